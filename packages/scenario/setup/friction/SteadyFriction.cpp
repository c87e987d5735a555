#include "scenario/setup/friction/SteadyFriction.hpp"

#include "base/Errors.hpp"
#include "parameters/Entries.hpp"
#include "parameters/fields/VertexDataset.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
char const* const rates_entry = "Table Slip Rate";
char const* const friction_entry = "Table Friction";

struct TableNames
{
  std::string rates, friction;
};

// They join those of the list.
Entries<TableNames> tableEntries(ParameterList& list)
{
  Entries<TableNames> entries({}, list);
  entries
    .text(rates_entry, &TableNames::rates, required,
          "This HDF5 dataset, \"file.h5:/dataset\", has slip rates [m/s], from the lowest to the "
          "highest. Steady friction beyond them is that of the nearest.")
    .text(friction_entry, &TableNames::friction, required,
          "This one has the friction coefficient of steady sliding at each of them; between them "
          "it is a monotone cubic in the logarithm of the slip rate.");
  return entries;
}

std::string described(char const* entry, std::string const& name)
{
  return joinPath(friction_path, entry) + " = '" + name + "'";
}

// The numbers of a dataset, which are finite and above zero.
std::vector<double> positiveNumbers(std::string const& name, char const* entry, char const* unit)
{
  ASPERITY_REQUIRE(VertexDataset::isName(name), described(entry, name)
                                                  << " is not the name of a dataset, as in "
                                                     "'table.h5:/friction'.");
  auto values = VertexDataset(name, joinPath(friction_path, entry)).readAll(unit);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASPERITY_REQUIRE(std::isfinite(values[i]) && values[i] > 0,
                     described(entry, name) << " has " << values[i] << " in row " << i
                                            << "; numbers above zero are wanted.");
  }
  return values;
}
} // namespace

void declareSteadyFriction(Declare& declare) { tableEntries(*declare.list()); }

friction::TableView steadyFriction(ParameterList const& list)
{
  ParameterList declared;
  auto const names = tableEntries(declared).read(list, friction_path);
  auto rates = positiveNumbers(names.rates, rates_entry, "m/s");
  auto const friction = positiveNumbers(names.friction, friction_entry, "-");
  ASPERITY_REQUIRE(rates.size() == friction.size() && rates.size() >= 2,
                   described(rates_entry, names.rates)
                     << " has " << rates.size() << " numbers, "
                     << described(friction_entry, names.friction) << " has " << friction.size()
                     << ". Two or more are wanted, and as many.");
  for (std::size_t i = 0; i < rates.size(); ++i) {
    rates[i] = std::log10(rates[i]);
    ASPERITY_REQUIRE(i == 0 || rates[i - 1] < rates[i], described(rates_entry, names.rates)
                                                          << " does not increase from row " << i - 1
                                                          << " to row " << i << ".");
  }
  return friction::makeTable(rates, friction);
}
} // namespace asperity::scenario
