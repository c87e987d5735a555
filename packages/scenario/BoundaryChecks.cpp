#include "scenario/BoundaryChecks.hpp"

#include "base/NearestName.hpp"
#include "scenario/NodalField.hpp"

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
  const std::map<std::string, std::string> reader = {{"Direction", "Prescribed Velocity"},
                                                     {"Velocity", "Prescribed Velocity"},
                                                     {"Ramp Duration", "Prescribed Velocity"},
                                                     {"Slip Rate", "Prescribed Slip Rate"}};
  for (auto const& condition : conditions) {
    for (auto const& [entry, type] : reader) {
      ASPERITY_REQUIRE(condition.type() == type || !isGiven(condition.list, entry),
                       joinPath(condition.name, entry)
                         << " has no effect: it belongs to the Type '" << type << "', and this is '"
                         << condition.type() << "'. Remove it, or choose that Type.");
    }
  }
}

void requireBoundaries(ParameterList const& list, Mesh<2> const& mesh)
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
} // namespace asperity::scenario
