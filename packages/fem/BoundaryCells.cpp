#include "fem/BoundaryCells.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <map>

namespace asperity::fem
{
template <int Dim>
std::vector<int> cellsBeside(Mesh<Dim> const& mesh, std::string const& boundary)
{
  using Facet = typename Mesh<Dim>::Facet;
  auto const& facets = mesh.boundaries.at(boundary);
  std::map<Facet, std::size_t> places;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    auto sorted = facets[i];
    std::sort(sorted.begin(), sorted.end());
    places.emplace(sorted, i);
  }
  std::vector<int> cells(facets.size(), -1);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (int left_out = 0; left_out <= Dim; ++left_out) {
      Facet facet;
      for (int i = 0, k = 0; i <= Dim; ++i) {
        if (i != left_out) {
          facet[k++] = mesh.cells[cell][i];
        }
      }
      std::sort(facet.begin(), facet.end());
      auto const found = places.find(facet);
      if (found != places.end()) {
        cells[found->second] = static_cast<int>(cell);
      }
    }
  }
  ASPERITY_ASSERT(std::find(cells.begin(), cells.end(), -1) == cells.end());
  return cells;
}

template <int Dim>
std::vector<Material> materialsAtNodes(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                       std::vector<Material> const& materials)
{
  auto const cells = cellsBeside(mesh, fault.name());
  auto const& facets = mesh.boundaries.at(fault.name());
  auto const vertices = fault.vertices();
  std::vector<Material> result(vertices.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const double measure = mesh::facetMeasure(mesh::corners(mesh, facets[i]));
    auto const& material = materials[cells[i]];
    for (int node : facets[i]) {
      auto const place = std::lower_bound(vertices.begin(), vertices.end(), node);
      if (place == vertices.end() || *place != node) {
        continue; // this node belongs to another rank
      }
      auto const n = place - vertices.begin();
      auto& sum = result[n];
      const double share = measure / Dim / fault[static_cast<int>(n)].weight;
      sum.density += share * material.density;
      sum.bulk_modulus += share * material.bulk_modulus;
      sum.shear_modulus += share * material.shear_modulus;
      sum.bulk_viscosity += share * material.bulk_viscosity;
      sum.shear_viscosity += share * material.shear_viscosity;
    }
  }
  return result;
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template std::vector<int> cellsBeside<DIM>(Mesh<DIM> const&, std::string const&);                \
  template std::vector<Material> materialsAtNodes<DIM>(Mesh<DIM> const&, FaultSurface const&,      \
                                                       std::vector<Material> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
} // namespace asperity::fem
