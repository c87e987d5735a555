#include "mesh/Boundaries.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/FacetTable.hpp"

#include <set>

namespace asperity::mesh
{
namespace
{
// The facets that belong to one cell only, outward, in the order of their vertices.
template <int Dim>
std::vector<typename GlobalMesh<Dim>::Facet> outerFacets(GlobalMesh<Dim> const& mesh)
{
  const detail::FacetTable<Dim> table(mesh.cells);
  auto const& entries = table.entries();
  std::vector<typename GlobalMesh<Dim>::Facet> outer;
  for (std::size_t first = 0; first < entries.size();) {
    std::size_t last = first + 1;
    while (last < entries.size() && entries[last].key == entries[first].key) {
      ++last;
    }
    if (last - first == 1) {
      outer.push_back(entries[first].outward);
    }
    first = last;
  }
  return outer;
}

// Outer facets that a condition gives a name, found by their sorted vertices.
template <int Dim>
class NamedFacets
{
public:
  using Facet = typename GlobalMesh<Dim>::Facet;

  NamedFacets(GlobalMesh<Dim> const& mesh, std::vector<NamedCondition<Dim>> const& conditions)
  {
    for (auto const& facet : outerFacets(mesh)) {
      const auto centre = centroid(corners<Dim>(mesh.vertices, facet));
      for (auto const& condition : conditions) {
        if (condition.holds(centre)) {
          named_[detail::sorted(facet)] = {condition.name, facet};
        }
      }
    }
  }

  bool contains(Facet const& facet) const { return named_.count(detail::sorted(facet)) > 0; }

  void requireAll(std::vector<NamedCondition<Dim>> const& conditions,
                  std::string const& where) const
  {
    std::set<std::string> used;
    for (auto const& [key, named] : named_) {
      used.insert(named.boundary);
    }
    for (auto const& condition : conditions) {
      ASPERITY_REQUIRE(used.count(condition.name) > 0,
                       where << " / " << condition.name << ": the boundary has no facet. Its "
                             << "condition holds at the centre of no outer facet of the body, or "
                             << "later ones take its facets.");
    }
  }

  void addTo(std::map<std::string, std::vector<Facet>>& boundaries) const
  {
    for (auto const& [key, named] : named_) {
      boundaries[named.boundary].push_back(named.outward);
    }
  }

private:
  struct Named
  {
    std::string boundary;
    Facet outward;
  };
  std::map<Facet, Named> named_;
};
} // namespace

template <int Dim>
void overrideBoundaries(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                        std::string const& where)
{
  const NamedFacets<Dim> named(mesh, conditions);
  named.requireAll(conditions, where);
  std::map<std::string, std::vector<typename GlobalMesh<Dim>::Facet>> boundaries;
  for (auto const& [name, facets] : mesh.boundaries) {
    for (auto const& facet : facets) {
      if (!named.contains(facet)) {
        boundaries[name].push_back(facet);
      }
    }
  }
  named.addTo(boundaries);
  mesh.boundaries = std::move(boundaries);
}

template void overrideBoundaries(GlobalMesh<2>&, std::vector<NamedCondition<2>> const&,
                                 std::string const&);
template void overrideBoundaries(GlobalMesh<3>&, std::vector<NamedCondition<3>> const&,
                                 std::string const&);
} // namespace asperity::mesh
