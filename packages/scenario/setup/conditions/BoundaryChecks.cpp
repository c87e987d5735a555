#include "scenario/setup/conditions/BoundaryChecks.hpp"

#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "base/parallel/FirstRank.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/TouchingFacets.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace asperity::scenario
{
namespace
{
bool contradict(BoundaryCondition const& a, BoundaryCondition const& b)
{
  const auto is_alone = [](DecidesOn on) {
    return on == DecidesOn::rest || on == DecidesOn::freedom;
  };
  const auto first = a.type->decides_on;
  const auto second = b.type->decides_on;
  return is_alone(first) || is_alone(second) ||
         (first == DecidesOn::traction && second == DecidesOn::traction);
}

bool decidesOnTraction(BoundaryCondition const& condition)
{
  const auto on = condition.type->decides_on;
  return !condition.liesAlongFault() && (on == DecidesOn::traction || on == DecidesOn::freedom);
}

// Facets that are counted over all ranks, and the place of one.
template <int Dim>
struct FoundFacets
{
  std::int64_t number = 0;
  std::string place;
};

// The facets of a boundary that `counts` accepts. Collective.
template <int Dim, class Counts>
FoundFacets<Dim> findFacets(Mesh<Dim> const& mesh, std::string const& boundary,
                            Communicator const& communicator, Counts const& counts)
{
  std::int64_t mine = 0;
  std::optional<Point<Dim>> first;
  for (auto const& facet : mesh.boundaries.at(boundary)) {
    const int least = *std::min_element(facet.begin(), facet.end(), [&mesh](int a, int b) {
      return mesh.global_ids[a] < mesh.global_ids[b];
    });
    if (least < mesh.num_owned && counts(facet)) { // each facet on one rank
      ++mine;
      first = first ? first : mesh::centroid(mesh::corners(mesh, facet));
    }
  }
  auto const place = ofFirstRank(first, communicator);
  return {sumOverRanks(mine, communicator), place ? mesh::text(*place) : ""};
}

// "the Type 'A' or 'B'"
std::string readersOf(std::string const& entry)
{
  std::string text;
  for (auto const& type : conditionTypes()) {
    if (type.readsEntry(entry)) {
      text += (text.empty() ? "the Type '" : " or '") + type.name + "'";
    }
  }
  return text;
}
} // namespace

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
        ASPERITY_REQUIRE(condition.type->readsEntry(entry) || !isGiven(condition.list, entry),
                         joinPath(condition.name, entry)
                           << " has no effect: it belongs to " << readersOf(entry)
                           << ", and this is '" << condition.type->name
                           << "'. Remove it, or choose that Type.");
      }
    }
  }
}

template <int Dim>
void requireBoundaries(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh)
{
  std::vector<std::string> names;
  for (auto const& entry : mesh.boundaries) {
    names.push_back(entry.first);
  }
  for (auto const& condition : conditions) {
    auto const& boundary = condition.boundary;
    ASPERITY_REQUIRE(mesh.boundaries.count(boundary) > 0, condition.name
                                                            << " / Boundary = '" << boundary
                                                            << "': the mesh has no such boundary."
                                                            << didYouMean(boundary, names));
  }
}

template <int Dim>
void requireFaults(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh,
                   Communicator const& communicator)
{
  const auto is_inside = [&mesh](std::string const& boundary) {
    return std::find(mesh.faults.begin(), mesh.faults.end(), boundary) != mesh.faults.end();
  };
  const auto isFault = [](BoundaryCondition const& condition) { return condition.type->isFault(); };
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
                                    << "' does not apply. Choose " << kinds << ", or '"
                                    << continuationType().name << "' where it continues one.");
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
  auto all_kinds = faultKindsInside();
  all_kinds.push_back(continuationType().name);
  for (auto const& fault : mesh.faults) {
    ASPERITY_REQUIRE(std::any_of(conditions.begin(), conditions.end(),
                                 [&fault](BoundaryCondition const& condition) {
                                   return condition.boundary == fault;
                                 }),
                     "Asperity / Boundary Conditions: nothing is said about the fault '"
                       << fault << "' inside the mesh. Add a condition of the Type "
                       << quotedAlternatives(all_kinds) << '.');
  }
}

template <int Dim>
void requireOwnFacets(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh,
                      Communicator const& communicator)
{
  using Facet = typename Mesh<Dim>::Facet;
  const auto sorted = [](Facet facet) {
    std::sort(facet.begin(), facet.end());
    return facet;
  };
  for (auto later = conditions.begin(); later != conditions.end(); ++later) {
    if (!decidesOnTraction(*later)) {
      continue;
    }
    std::set<Facet> facets;
    for (auto const& facet : mesh.boundaries.at(later->boundary)) {
      facets.insert(sorted(facet));
    }
    for (auto other = conditions.begin(); other != later; ++other) {
      const bool are_free =
        later->type == other->type && later->type->decides_on == DecidesOn::freedom;
      if (!decidesOnTraction(*other) || are_free) {
        continue;
      }
      auto const common = findFacets(mesh, other->boundary, communicator, [&](Facet const& facet) {
        return facets.count(sorted(facet)) > 0;
      });
      ASPERITY_REQUIRE(common.number == 0,
                       later->name << " (" << later->type->name << " on '" << later->boundary
                                   << "') and " << other->name << " (" << other->type->name
                                   << " on '" << other->boundary << "') have "
                                   << counted(common.number, "facet") << " in common, one at "
                                   << common.place
                                   << " m, where both would act. Give each facet one of them: "
                                      "remove a condition, or divide the boundaries in the mesh.");
    }
  }
}

template <int Dim>
void requirePlaneOfMirror(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh,
                          Communicator const& communicator)
{
  constexpr double largest_angle = 1; // degrees
  std::string fault;
  std::vector<std::string> boundaries;
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      boundaries.push_back(condition.boundary);
    }
    if (condition.type->isFault() && condition.type->other_side.is_mirrored) {
      fault = condition.name + " (" + condition.type->name + ")";
    }
  }
  if (fault.empty()) {
    return;
  }
  auto const [sum, measure] = fem::integrateNormal(mesh, boundaries, communicator);
  Point<Dim> mean;
  std::copy_n(sum.begin(), Dim, mean.begin());
  const double length = std::sqrt(mesh::dot<Dim>(mean, mean));
  for (auto const& boundary : boundaries) {
    auto const off = findFacets(mesh, boundary, communicator, [&](auto const& facet) {
      auto const normal = mesh::facetNormal(mesh::corners(mesh, facet));
      return mesh::dot<Dim>(normal, mean) < std::cos(largest_angle * M_PI / 180) * length;
    });
    ASPERITY_REQUIRE(off.number == 0 && (length > 0 || !(measure > 0)),
                     fault << ": it mirrors the body in its plane, but the boundary '" << boundary
                           << "' is not in one plane: the normal of "
                           << counted(off.number, "facet") << ", one at " << off.place
                           << " m, is more than " << formatShort(largest_angle)
                           << " degree off the mean normal. Take a plane boundary, or put both "
                              "sides into the mesh and choose the Type 'Two-Sided Fault'.");
  }
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template void requireOwnFacets(std::vector<BoundaryCondition> const&, Mesh<Dim> const&,          \
                                 Communicator const&);                                             \
  template void requirePlaneOfMirror(std::vector<BoundaryCondition> const&, Mesh<Dim> const&,      \
                                     Communicator const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE

template void requireFaults(std::vector<BoundaryCondition> const&, Mesh<2> const&,
                            Communicator const&);
template void requireFaults(std::vector<BoundaryCondition> const&, Mesh<3> const&,
                            Communicator const&);
template void requireBoundaries(std::vector<BoundaryCondition> const&, Mesh<2> const&);
template void requireBoundaries(std::vector<BoundaryCondition> const&, Mesh<3> const&);
} // namespace asperity::scenario
