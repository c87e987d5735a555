#include "fem/BoundaryCells.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/SplitVertices.hpp"

#include <algorithm>
#include <map>

namespace asperity::fem
{
namespace
{
// The cells beside facets, which consist of vertices of cells: at a split vertex, of the vertex on
// that side.
template <int Dim>
std::vector<int> cellsOf(Mesh<Dim> const& mesh,
                         std::vector<typename Mesh<Dim>::Facet> const& facets)
{
  using Facet = typename Mesh<Dim>::Facet;
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

// The facets of a boundary by the vertices of the cells on one side.
template <int Dim>
std::vector<typename Mesh<Dim>::Facet> facetsOnSide(Mesh<Dim> const& mesh,
                                                    std::string const& boundary, Side side)
{
  const mesh::FaultSides<Dim> sides(mesh);
  auto facets = mesh.boundaries.at(boundary);
  for (auto& facet : facets) {
    facet = side == Side::plus ? sides.plusSide(facet) : sides.minusSide(facet);
  }
  return facets;
}

// (num_nodes) the mean over the facets of the fault at each node.
template <int Dim>
std::vector<Material> materialsOnSide(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                      std::vector<Material> const& materials, Side side)
{
  auto const cells = cellsBeside(mesh, fault.name(), side);
  auto const& facets = mesh.boundaries.at(fault.name());
  std::vector<Material> result(fault.numNodes());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const double measure = mesh::facetMeasure(mesh::corners(mesh, facets[i]));
    auto const& material = materials[cells[i]];
    for (int vertex : facets[i]) {
      const int node = fault.nodeAt(vertex);
      if (node < 0) {
        continue; // it belongs to another rank
      }
      auto& sum = result[node];
      const double share = measure / Dim / fault[node].weight;
      sum.density += share * material.density;
      sum.bulk_modulus += share * material.bulk_modulus;
      sum.shear_modulus += share * material.shear_modulus;
      sum.bulk_viscosity += share * material.bulk_viscosity;
      sum.shear_viscosity += share * material.shear_viscosity;
    }
  }
  return result;
}

double harmonicMean(double a, double b) { return 2 * a * b / (a + b); }

// The two sides in series: their compliances add, and so do their inverse impedances.
Material inSeries(Material const& a, Material const& b)
{
  Material result;
  result.shear_modulus = harmonicMean(a.shear_modulus, b.shear_modulus);
  result.bulk_modulus = harmonicMean(a.bulk_modulus, b.bulk_modulus);
  const double impedance = harmonicMean(a.shearImpedance(), b.shearImpedance());
  result.density = impedance * impedance / result.shear_modulus;
  result.shear_viscosity = (a.shear_viscosity + b.shear_viscosity) / 2;
  result.bulk_viscosity = (a.bulk_viscosity + b.bulk_viscosity) / 2;
  return result;
}
} // namespace

template <int Dim>
std::vector<int> cellsBeside(Mesh<Dim> const& mesh, std::string const& boundary, Side side)
{
  return cellsOf(mesh, facetsOnSide(mesh, boundary, side));
}

template <int Dim>
std::vector<Material> materialsAtNodes(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                       std::vector<Material> const& materials)
{
  auto result = materialsOnSide(mesh, fault, materials, Side::plus);
  if (fault.otherSide().is_inside) {
    auto const below = materialsOnSide(mesh, fault, materials, Side::minus);
    std::transform(result.begin(), result.end(), below.begin(), result.begin(), inSeries);
  }
  return result;
}

#define ASPERITY_INSTANTIATE(DIM)                                                                  \
  template std::vector<int> cellsBeside<DIM>(Mesh<DIM> const&, std::string const&, Side);          \
  template std::vector<Material> materialsAtNodes<DIM>(Mesh<DIM> const&, FaultSurface const&,      \
                                                       std::vector<Material> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::fem
