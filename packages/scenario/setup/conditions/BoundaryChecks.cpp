#include "scenario/setup/conditions/BoundaryChecks.hpp"

#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "mesh/TouchingFacets.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
bool contradict(BoundaryCondition const& a, BoundaryCondition const& b)
{
  const auto first = a.type->decides_on;
  const auto second = b.type->decides_on;
  return first == DecidesOn::everything || second == DecidesOn::everything ||
         (first == DecidesOn::traction && second == DecidesOn::traction);
}

bool reads(ConditionType const& type, std::string const& entry)
{
  return std::find(type.reads.begin(), type.reads.end(), entry) != type.reads.end();
}

// "the Type 'A' or 'B'"
std::string readersOf(std::string const& entry)
{
  std::string text;
  for (auto const& type : conditionTypes()) {
    if (reads(type, entry)) {
      text += (text.empty() ? "the Type '" : " or '") + type.name + "'";
    }
  }
  return text;
}
} // namespace

std::vector<BoundaryCondition> readConditions(ParameterList const& list)
{
  std::vector<BoundaryCondition> conditions;
  for (auto const& entry : list) {
    conditions.emplace_back(joinPath("Asperity / Boundary Conditions", entry.first),
                            list.sublist(entry.first));
  }
  return conditions;
}

void refuseContradictions(std::vector<BoundaryCondition> const& conditions)
{
  for (auto later = conditions.begin(); later != conditions.end(); ++later) {
    for (auto other = conditions.begin(); other != later; ++other) {
      ASPERITY_REQUIRE(later->boundary != other->boundary || !contradict(*later, *other),
                       later->name << " (" << later->type->name << ") contradicts " << other->name
                                   << " (" << other->type->name << ") on the boundary '"
                                   << later->boundary << "'. Remove one of them.");
    }
  }
}

void refuseUnreadEntries(std::vector<BoundaryCondition> const& conditions)
{
  for (auto const& condition : conditions) {
    for (auto const& type : conditionTypes()) {
      for (auto const& entry : type.reads) {
        ASPERITY_REQUIRE(reads(*condition.type, entry) || !isGiven(condition.list, entry),
                         joinPath(condition.name, entry)
                           << " has no effect: it belongs to " << readersOf(entry)
                           << ", and this is '" << condition.type->name
                           << "'. Remove it, or choose that Type.");
      }
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
    auto const& boundary = condition.boundary;
    ASPERITY_REQUIRE(mesh.boundaries.count(boundary) > 0, condition.name
                                                            << " / Boundary = '" << boundary
                                                            << "': the mesh has no such boundary."
                                                            << didYouMean(boundary, names));
  }
}

template <int Dim>
void requireFaults(ParameterList const& list, Mesh<Dim> const& mesh,
                   Communicator const& communicator)
{
  auto const conditions = readConditions(list);
  const auto is_inside = [&mesh](std::string const& boundary) {
    return std::find(mesh.faults.begin(), mesh.faults.end(), boundary) != mesh.faults.end();
  };
  const auto isFault = [](BoundaryCondition const& condition) {
    return condition.type->place == ConditionPlace::fault;
  };
  const bool known_alone = std::none_of(conditions.begin(), conditions.end(), isFault);
  const bool two_sided =
    known_alone || std::any_of(conditions.begin(), conditions.end(),
                               [](auto const& condition) { return condition.isFaultInside(); });
  auto const kinds = quotedAlternatives(faultKindsInside());
  for (auto const& condition : conditions) {
    auto const& type = condition.type->name;
    ASPERITY_REQUIRE(!is_inside(condition.boundary) || (two_sided && condition.liesAlongFault()),
                     condition.name << " / Boundary = '" << condition.boundary
                                    << "' is a fault inside the body, where the Type '" << type
                                    << "' does not apply. Choose " << kinds
                                    << ", or 'Prescribed Slip Rate' where it continues one.");
    if (!is_inside(condition.boundary) && two_sided && condition.liesAlongFault()) {
      const auto touching = mesh::touchingFacets(mesh, communicator);
      const std::string way_out =
        known_alone ? " A fault on the outer boundary needs a Type that says what lies on its "
                      "other side, " +
                        quotedAlternatives(faultKinds()) + ", with the same Slip Rate."
                    : "";
      throw InputError(condition.name + " / Boundary = '" + condition.boundary +
                       "' is no fault inside the body, which the Type '" + type + "' needs here. " +
                       (touching
                          ? mesh::sentence(*touching)
                          : "Give it in Mesh / Faults, or mark facets inside the mesh." + way_out));
    }
  }
  for (auto const& fault : mesh.faults) {
    ASPERITY_REQUIRE(std::any_of(conditions.begin(), conditions.end(),
                                 [&fault](BoundaryCondition const& condition) {
                                   return condition.boundary == fault;
                                 }),
                     "Asperity / Boundary Conditions: nothing is said about the fault '"
                       << fault << "' inside the mesh. Add a condition of the Type " << kinds
                       << " or 'Prescribed Slip Rate'.");
  }
}

template void requireFaults(ParameterList const&, Mesh<2> const&, Communicator const&);
template void requireFaults(ParameterList const&, Mesh<3> const&, Communicator const&);
template void requireBoundaries(ParameterList const&, Mesh<2> const&);
template void requireBoundaries(ParameterList const&, Mesh<3> const&);
} // namespace asperity::scenario
