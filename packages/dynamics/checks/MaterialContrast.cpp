#include "dynamics/checks/MaterialContrast.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
constexpr double least_share = 0.01;

double difference(double a, double b) { return std::abs(a - b) / std::max(a, b); }

double difference(fem::Material const& a, fem::Material const& b)
{
  return std::max({difference(a.density, b.density), difference(a.bulk_modulus, b.bulk_modulus),
                   difference(a.shear_modulus, b.shear_modulus)});
}

double shearSpeed(fem::Material const& material)
{
  return std::sqrt(material.shear_modulus / material.density);
}
} // namespace

template <int Dim>
PlacesBeside placesBeside(Mesh<Dim> const& mesh, fem::FaultSurface const& surface, fem::Side side)
{
  constexpr double part = 1e-3; // of the way
  auto const cells = fem::cellsBeside(mesh, surface.name(), side);
  auto const& facets = mesh.boundaries.at(surface.name());
  PlacesBeside result;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const bool slides = std::any_of(facets[i].begin(), facets[i].end(), [&](int vertex) {
      const int node = surface.nodeAt(vertex);
      return node >= 0 && surface.slides(node);
    });
    if (slides) {
      auto const at = mesh::centroid(mesh::corners(mesh, facets[i]));
      auto const centre = mesh::centroid(mesh::corners(mesh, mesh.cells[cells[i]]));
      std::array<double, 3> place{};
      for (int d = 0; d < Dim; ++d) {
        place[d] = at[d] + part * (centre[d] - at[d]);
      }
      result.places.push_back(place);
      result.cells.push_back(cells[i]);
    }
  }
  return result;
}

MaterialContrast materialContrast(std::vector<std::array<double, 3>> const& places,
                                  std::vector<fem::Material> const& plus,
                                  std::vector<fem::Material> const& minus,
                                  Communicator const& communicator)
{
  MaterialContrast mine;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double share = difference(plus[i], minus[i]);
    if (share > mine.share) {
      mine = {share, places[i], {shearSpeed(plus[i]), shearSpeed(minus[i])}};
    }
  }
  const double share = maxOverRanks(mine.share, communicator);
  const int rank = communicator.getRank(), none = communicator.getSize();
  const int owner = minOverRanks(share > 0 && mine.share == share ? rank : none, communicator);
  if (owner == none) {
    return {};
  }
  constexpr double lowest = std::numeric_limits<double>::lowest();
  std::array<double, 5> values = {lowest, lowest, lowest, lowest, lowest};
  if (rank == owner) {
    values = {mine.place[0], mine.place[1], mine.place[2], mine.speeds[0], mine.speeds[1]};
  }
  values = maxOverRanks(values, communicator);
  return {share, {values[0], values[1], values[2]}, {values[3], values[4]}};
}

std::optional<Warning> warnOfContrast(MaterialContrast const& contrast, std::string const& change)
{
  if (contrast.share <= least_share) {
    return std::nullopt;
  }
  return Warning{
    "material contrast",
    "The rock differs across the fault by up to " + formatShort(100 * contrast.share) +
      " % in density or a modulus, at " +
      formatPoint({contrast.place.begin(), contrast.place.end()}) +
      " (c_s = " + formatShort(contrast.speeds[0]) + " m/s on the plus side, " +
      formatShort(contrast.speeds[1]) +
      " m/s on the other), the body has inertia, and friction follows the normal stress at once "
      "(Friction / Normal Stress Change = " +
      change +
      "). This problem is ill-posed: the shorter a wave, the faster it grows, so that slip rates "
      "and ruptures depend on the cell size and do not converge. Choose Normal Stress Change = "
      "Prakash-Clifton."};
}

template PlacesBeside placesBeside(Mesh<2> const&, fem::FaultSurface const&, fem::Side);
template PlacesBeside placesBeside(Mesh<3> const&, fem::FaultSurface const&, fem::Side);
} // namespace asperity::dynamics
