#include "mesh/faults/Facing.hpp"

#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::mesh
{
namespace
{
// A facet, and the part of it that counts on this rank.
template <int Dim>
struct FacetShare
{
  std::array<Point<Dim>, Dim> corners;
  double part = 1;
};

// sum: over the ranks.
template <int Dim, class Sum>
Facing facingOfShares(std::vector<FacetShare<Dim>> const& facets, Sum const& sum)
{
  std::array<double, 7> mine{}; // normal, place times measure, measure
  for (auto const& [corners, part] : facets) {
    auto const normal = areaNormal(corners);
    auto const place = centroid(corners);
    const double size = part * facetMeasure(corners);
    for (int d = 0; d < Dim; ++d) {
      mine[d] += part * normal[d];
      mine[3 + d] += size * place[d];
    }
    mine[6] += size;
  }
  const std::array<double, 7> all = sum(mine);
  Facing result;
  std::copy_n(all.begin(), 3, result.normal.begin());
  result.measure = all[6];
  if (!(result.measure > 0)) { // on all ranks
    return result;
  }
  Point<Dim> centre;
  for (int d = 0; d < Dim; ++d) {
    centre[d] = all[3 + d] / result.measure;
  }
  std::array<double, 2> around{};
  for (auto const& [corners, part] : facets) {
    auto const place = difference<Dim>(centroid(corners), centre);
    around[0] += part * dot<Dim>(place, areaNormal(corners));
    around[1] += part * facetMeasure(corners) * std::sqrt(dot<Dim>(place, place));
  }
  around = sum(around);
  result.outwards = around[0];
  result.extent = around[1];
  return result;
}

} // namespace

bool Facing::hasMeanNormal() const
{
  constexpr double rounding = 1e-10;
  return std::sqrt(dot<3>(normal, normal)) > rounding * measure;
}

bool Facing::partsFaceEachOther() const
{
  constexpr double facing = 0.05; // of the mean normal
  return std::sqrt(dot<3>(normal, normal)) < facing * measure;
}

bool Facing::isRing() const
{
  constexpr double enclosing = 0.1; // of the mean part of x - c across the facets, over |x - c|
  return partsFaceEachOther() && std::abs(outwards) > enclosing * extent;
}

template <int Dim>
Facing facingOf(std::vector<std::array<Point<Dim>, Dim>> const& facets)
{
  std::vector<FacetShare<Dim>> whole;
  for (auto const& corners : facets) {
    whole.push_back({corners});
  }
  return facingOfShares<Dim>(whole, [](auto const& mine) { return mine; });
}

template <int Dim>
Facing facingOf(Mesh<Dim> const& mesh, std::vector<std::string> const& boundaries,
                Communicator const& communicator)
{
  std::vector<FacetShare<Dim>> shares;
  for (auto const& name : boundaries) {
    for (auto const& facet : boundaryFacets(mesh, name)) {
      // Every vertex of a facet is owned by one rank, which has the facet.
      const auto owned = std::count_if(facet.begin(), facet.end(),
                                       [&](int vertex) { return vertex < mesh.num_owned; });
      shares.push_back({corners(mesh, facet), static_cast<double>(owned) / Dim});
    }
  }
  return facingOfShares<Dim>(shares,
                             [&](auto const& mine) { return sumOverRanks(mine, communicator); });
}

template Facing facingOf<2>(std::vector<std::array<Point<2>, 2>> const&);
template Facing facingOf<3>(std::vector<std::array<Point<3>, 3>> const&);
template Facing facingOf(Mesh<2> const&, std::vector<std::string> const&, Communicator const&);
template Facing facingOf(Mesh<3> const&, std::vector<std::string> const&, Communicator const&);
} // namespace asperity::mesh
