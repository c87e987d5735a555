#include "scenario/setup/friction/SteadyFriction.hpp"

#include "base/Errors.hpp"
#include "parameters/fields/VertexDataset.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <cmath>

namespace asperity::scenario
{
namespace
{
char const* const rates_entry = "Table Slip Rate";
char const* const friction_entry = "Table Friction";

std::string described(ParameterList const& list, char const* entry)
{
  return joinPath(friction_path, entry) + " = '" + list.get<std::string>(entry) + "'";
}

// The numbers of a dataset, which are finite and above zero.
std::vector<double> positiveNumbers(ParameterList const& list, char const* entry, char const* unit)
{
  auto const& name = list.get<std::string>(entry);
  ASPERITY_REQUIRE(VertexDataset::isName(name), described(list, entry)
                                                  << " is not the name of a dataset, as in "
                                                     "'table.h5:/friction'.");
  auto values = VertexDataset(name, joinPath(friction_path, entry)).readAll(unit);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASPERITY_REQUIRE(std::isfinite(values[i]) && values[i] > 0,
                     described(list, entry) << " has " << values[i] << " in row " << i
                                            << "; numbers above zero are wanted.");
  }
  return values;
}
} // namespace

void declareSteadyFriction(Declare& declare)
{
  declare
    .text(rates_entry, required,
          "This HDF5 dataset, \"file.h5:/dataset\", has slip rates [m/s], from the lowest to the "
          "highest. Steady friction beyond them is that of the nearest.")
    .text(friction_entry, required,
          "This one has the friction coefficient of steady sliding at each of them; between them "
          "it is a monotone cubic in the logarithm of the slip rate.");
}

friction::TableView steadyFriction(ParameterList const& list)
{
  auto rates = positiveNumbers(list, rates_entry, "m/s");
  auto const friction = positiveNumbers(list, friction_entry, "-");
  ASPERITY_REQUIRE(rates.size() == friction.size() && rates.size() >= 2,
                   described(list, rates_entry)
                     << " has " << rates.size() << " numbers, " << described(list, friction_entry)
                     << " has " << friction.size() << ". Two or more are wanted, and as many.");
  for (std::size_t i = 0; i < rates.size(); ++i) {
    rates[i] = std::log10(rates[i]);
    ASPERITY_REQUIRE(i == 0 || rates[i - 1] < rates[i], described(list, rates_entry)
                                                          << " does not increase from row " << i - 1
                                                          << " to row " << i << ".");
  }
  return friction::makeTable(rates, friction);
}
} // namespace asperity::scenario
