#include "catalogue/events/EventEnergies.hpp"

#include "io/files/TextTable.hpp"

#include <algorithm>

namespace asperity::catalogue
{
namespace
{
constexpr char const* energies[] = {
  "kinetic_energy", "elastic_energy", "load_work",    "boundary_work",         "friction_work",
  "viscous_work",   "inelastic_work", "contact_work", "numerical_dissipation", "energy_defect"};
} // namespace

EventEnergies::EventEnergies(io::FieldRegistry const& registry)
{
  const auto known = registry.scalarNames();
  for (char const* name : energies) {
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      scalars_.push_back(&registry.scalar(name));
    }
  }
}

std::string EventEnergies::header() const
{
  std::string text;
  for (io::OutputScalar const* scalar : scalars_) {
    text += ',' + io::columnName(scalar->name, scalar->unit);
  }
  return text;
}

std::vector<double> EventEnergies::sample() const
{
  std::vector<double> values;
  for (io::OutputScalar const* scalar : scalars_) {
    values.push_back(scalar->value());
  }
  return values;
}

std::string EventEnergies::columns(std::vector<double> const& before,
                                   std::vector<double> const& after) const
{
  std::string text;
  for (std::size_t i = 0; i < scalars_.size(); ++i) {
    text += ',' + io::shortNumber(after[i] - before[i]);
  }
  return text;
}
} // namespace asperity::catalogue
