#include "scenario/setup/BoundaryChecks.hpp"

#include "base/NearestName.hpp"
#include "scenario/setup/NodalField.hpp"

#include <algorithm>
#include <map>

namespace asperity::scenario
{
namespace
{
bool leavesNoRoom(BoundaryCondition const& condition)
{
  return condition.type() == "Free Surface" || condition.type() == "Fixed";
}

bool contradict(BoundaryCondition const& a, BoundaryCondition const& b)
{
  const auto takes_tractions = [](BoundaryCondition const& condition) {
    return condition.liesAlongFault() || condition.type() == "Absorbing";
  };
  return leavesNoRoom(a) || leavesNoRoom(b) || (takes_tractions(a) && takes_tractions(b));
}
} // namespace

std::vector<BoundaryCondition> readConditions(ParameterList const& list)
{
  std::vector<BoundaryCondition> conditions;
  for (auto const& entry : list) {
    conditions.push_back(
      {joinPath("Asperity / Boundary Conditions", entry.first), list.sublist(entry.first)});
  }
  return conditions;
}

void refuseContradictions(std::vector<BoundaryCondition> const& conditions)
{
  for (auto later = conditions.begin(); later != conditions.end(); ++later) {
    for (auto other = conditions.begin(); other != later; ++other) {
      ASPERITY_REQUIRE(later->boundary() != other->boundary() || !contradict(*later, *other),
                       later->name << " (" << later->type() << ") contradicts " << other->name
                                   << " (" << other->type() << ") on the boundary '"
                                   << later->boundary() << "'. Remove one of them.");
    }
  }
}

void refuseUnreadEntries(std::vector<BoundaryCondition> const& conditions)
{
  const std::multimap<std::string, std::string> readers = {{"Direction", "Prescribed Velocity"},
                                                           {"Direction", "Prescribed Slip Rate"},
                                                           {"Velocity", "Prescribed Velocity"},
                                                           {"Ramp Duration", "Prescribed Velocity"},
                                                           {"Slip Rate", "Prescribed Slip Rate"}};
  for (auto const& condition : conditions) {
    for (auto reader = readers.begin(); reader != readers.end();) {
      auto const [first, last] = readers.equal_range(reader->first);
      const bool is_read = std::any_of(
        first, last, [&](auto const& entry) { return entry.second == condition.type(); });
      ASPERITY_REQUIRE(is_read || !isGiven(condition.list, reader->first),
                       joinPath(condition.name, reader->first)
                         << " has no effect: it belongs to the Type '" << first->second
                         << "', and this is '" << condition.type()
                         << "'. Remove it, or choose that Type.");
      reader = last;
    }
  }
}

template <int Dim>
void requireBoundaries(ParameterList const& list, Mesh<Dim> const& mesh)
{
  std::vector<std::string> names;
  for (auto const& entry : mesh.boundaries) {
    names.push_back(entry.first);
  }
  for (auto const& condition : readConditions(list)) {
    auto const boundary = condition.boundary();
    ASPERITY_REQUIRE(mesh.boundaries.count(boundary) > 0, condition.name
                                                            << " / Boundary = '" << boundary
                                                            << "': the mesh has no such boundary."
                                                            << didYouMean(boundary, names));
  }
}

template void requireBoundaries(ParameterList const&, Mesh<2> const&);
template void requireBoundaries(ParameterList const&, Mesh<3> const&);
} // namespace asperity::scenario
