#include "mesh/faults/Faults.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/InnerBoundaries.hpp"

namespace asperity::mesh
{
namespace
{
template <int Dim>
using Facets = std::vector<typename GlobalMesh<Dim>::Facet>;

// The number of the last condition that holds on the facet; -1 if none does.
template <int Dim>
int conditionOn(std::array<Point<Dim>, Dim> const& corners,
                std::vector<NamedCondition<Dim>> const& conditions)
{
  const auto centre = centroid(corners);
  for (auto c = static_cast<int>(conditions.size()) - 1; c >= 0; --c) {
    auto const& holds = conditions[static_cast<std::size_t>(c)].holds;
    if (std::all_of(corners.begin(), corners.end(), holds) && holds(centre)) {
      return c;
    }
  }
  return -1;
}

// The facets inside the body on which a condition holds, by their sorted vertices.
template <int Dim>
std::map<typename GlobalMesh<Dim>::Facet, int>
facetsOnFaults(GlobalMesh<Dim> const& mesh, detail::FacetTable<Dim> const& table,
               std::vector<NamedCondition<Dim>> const& conditions)
{
  std::map<typename GlobalMesh<Dim>::Facet, int> found;
  auto const& entries = table.entries();
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].key == entries[i - 1].key) {
      const int condition = conditionOn<Dim>(corners(mesh, entries[i].key), conditions);
      if (condition >= 0) {
        found[entries[i].key] = condition;
      }
    }
  }
  return found;
}
} // namespace

template <int Dim>
void addFaults(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
               std::string const& where)
{
  if (conditions.empty()) {
    return;
  }
  const detail::FacetTable<Dim> table(mesh.cells);
  const auto known = detail::innerBoundaries(mesh, table, where);
  const auto on_faults = facetsOnFaults(mesh, table, conditions);
  std::map<std::string, Facets<Dim>> added;
  for (auto const& [facet, condition] : on_faults) {
    added[conditions[static_cast<std::size_t>(condition)].name].push_back(facet);
  }
  for (auto const& condition : conditions) {
    ASPERITY_REQUIRE(mesh.boundaries.count(condition.name) == 0 ||
                       std::binary_search(known.begin(), known.end(), condition.name),
                     where << " / " << condition.name
                           << ": a boundary on the surface of the body has this name. Give the "
                              "fault another one.");
    ASPERITY_REQUIRE(added.count(condition.name) > 0,
                     where << " / " << condition.name
                           << ": the fault has no facet. Its condition holds at the centre and all "
                           << "vertices of no facet inside the body, or the conditions of later "
                           << "faults take its facets. Edges of cells must lie along the fault.");
  }
  for (auto const& name : known) {
    auto& facets = mesh.boundaries.at(name);
    facets.erase(
      std::remove_if(facets.begin(), facets.end(),
                     [&](auto const& facet) { return on_faults.count(detail::sorted(facet)) > 0; }),
      facets.end());
    if (facets.empty()) {
      mesh.boundaries.erase(name);
    }
  }
  for (auto const& [name, facets] : added) {
    auto& all = mesh.boundaries[name];
    all.insert(all.end(), facets.begin(), facets.end());
  }
}

template void addFaults(GlobalMesh<2>&, std::vector<NamedCondition<2>> const&, std::string const&);
template void addFaults(GlobalMesh<3>&, std::vector<NamedCondition<3>> const&, std::string const&);
} // namespace asperity::mesh
