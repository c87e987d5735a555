#pragma once

#include "base/Warning.hpp"
#include "fem/BoundaryCells.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/bulk/Material.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asperity::dynamics
{
// A place beside each facet of a fault that has a sliding node, and the cell that it lies in, on
// one side: a thousandth of the way from the centre of the facet to that of the cell. There a field
// of the rock has its value at the fault, whether it jumps at the fault or varies in space.
struct PlacesBeside
{
  std::vector<std::array<double, 3>> places; // [m]
  std::vector<int> cells;
};
// The facets of this rank, in the same order on both sides.
template <int Dim>
PlacesBeside placesBeside(Mesh<Dim> const& mesh, fem::FaultSurface const& surface, fem::Side side);

// How much the rock differs between the two sides of a fault, where it differs most.
struct MaterialContrast
{
  double share = 0;               // |x+ - x-| / max(x+, x-), the largest of density, K and G
  std::array<double, 3> place{};  // there [m]
  std::array<double, 2> speeds{}; // c_s there on the plus and on the minus side [m/s]
};

// The largest contrast of these materials on the two sides of places (num_places). Collective.
MaterialContrast materialContrast(std::vector<std::array<double, 3>> const& places,
                                  std::vector<fem::Material> const& plus,
                                  std::vector<fem::Material> const& minus,
                                  Communicator const& communicator);

// A warning that answers depend on the mesh: with inertia and a friction that follows the normal
// stress at once, sliding between unlike half spaces is ill-posed (Renardy 1992; Adams 1995;
// Ranjith and Rice 2001), for any friction where a generalised Rayleigh wave exists, else above
// some. A wave of wavenumber k grows at 0.31 mu d k c_s with friction mu and a small difference d
// of the speeds. None up to a contrast of 1 %, d = 0.5 %: with mu = 0.6, a wave of four cells grows
// by less than e^1.5 there while it runs along a thousand cells. `change` is the deck's choice of
// how the normal stress changes.
std::optional<Warning> warnOfContrast(MaterialContrast const& contrast, std::string const& change);
} // namespace asperity::dynamics
