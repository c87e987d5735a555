#include "mesh/detail/InnerBoundaries.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"

namespace asperity::mesh::detail
{
template <int Dim>
std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                                         std::string const& where)
{
  std::vector<std::string> names;
  for (auto const& [name, facets] : mesh.boundaries) {
    using Facet = typename GlobalMesh<Dim>::Facet;
    Facet const* inner = nullptr;
    Facet const* outer = nullptr;
    for (auto const& facet : facets) {
      const auto [first, last] = table.find(facet);
      (last - first == 2 ? inner : outer) = &facet;
    }
    ASPERITY_REQUIRE(!inner || !outer,
                     where << ": boundary '" << name << "' has facets inside the body, one at "
                           << text(centroid(corners(mesh, *inner)))
                           << ", and on its surface, one at "
                           << text(centroid(corners(mesh, *outer)))
                           << ". Facets inside the body are a fault: give them a name of their "
                              "own.");
    if (inner) {
      names.push_back(name);
    }
  }
  return names;
}

template <int Dim>
std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const& mesh, std::string const& where)
{
  return innerBoundaries(mesh, FacetTable<Dim>(mesh.cells), where);
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const&,                        \
                                                    FacetTable<Dim> const&, std::string const&);   \
  template std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const&, std::string const&);
ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh::detail
