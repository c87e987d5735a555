#include "scenario/setup/rock/StressAtStart.hpp"

#include "scenario/setup/DeckPaths.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
constexpr std::array<char const*, 6> component_names = {"XX", "XY", "XZ", "YY", "YZ", "ZZ"};
constexpr std::array<int, 3> diagonal = {0, 3, 5};
} // namespace

RCP<const ParameterList> StressAtStart::validParameters()
{
  Declare declare;
  for (char const* name : component_names) {
    declare.field(name, optional, "Pa", Range::any(),
                  "The stress at the start has this component, which is 0 if it is left out.");
  }
  return declare.list();
}

StressAtStart::StressAtStart(ParameterList const& list,
                             std::vector<std::string> const& region_names)
{
  for (char const* name : component_names) {
    fields_.push_back(isGiven(list, name)
                        ? std::optional<CellField>(
                            steadyField(list, name, joinPath(bulk_path, list_name), region_names))
                        : std::nullopt);
  }
}

void StressAtStart::append(CellPlace const& place, int components, fem::YieldingRock& rock) const
{
  std::array<double, 6> value{};
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    value[k] = fields_[k] ? (*fields_[k])(place) : 0;
  }
  auto const [xx, xy, xz, yy, yz, zz] = value;
  const std::vector<double> tensor = components == 1 ? std::vector<double>{xz, yz}
                                     : components == 2
                                       ? std::vector<double>{xx, xy, yy, zz}
                                       : std::vector<double>(value.begin(), value.end());
  rock.initial_stress.insert(rock.initial_stress.end(), tensor.begin(), tensor.end());
  rock.initial_mean.push_back((xx + yy + zz) / 3);
}

StressAtStart::Components StressAtStart::atNodes(ParameterList const& list, FieldNodes const& nodes)
{
  Components result;
  for (std::size_t k = 0; k < result.size(); ++k) {
    result[k] = isGiven(list, component_names[k])
                  ? nodalValues(list, component_names[k], joinPath(bulk_path, list_name), nodes)
                  : std::vector<double>(nodes.ids.size(), 0.);
  }
  return result;
}

bool StressAtStart::givesMean(ParameterList const& list)
{
  return std::any_of(diagonal.begin(), diagonal.end(),
                     [&list](int k) { return isGiven(list, component_names[k]); });
}
} // namespace asperity::scenario
