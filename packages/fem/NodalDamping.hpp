#pragma once

#include "base/Types.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/dofs/DofMap.hpp"
#include "mesh/Mesh.hpp"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::fem
{
// Dampers of owned nodes: blocks in nodal frames, row-major in the leading components x components
// entries [N s/m, in 2D per metre], by the nodes of their rows and columns. The two nodes differ
// only at the pair of a split vertex. The matrix of all blocks is symmetric. Springs have the same
// form [N/m].
using NodalDampers = std::map<std::pair<int, int>, std::array<double, 9>>;

// How a boundary resists motion q: by a traction -across q_n - along q_t, where q_n is the part of
// q along the boundary's normal (antiplane: -along q). q is the velocity, for dashpots, or the
// displacement, for springs. None of the two is negative.
struct BoundaryResistance
{
  enum class Against
  {
    velocity,    // [Pa s/m]
    displacement // [Pa/m]
  };
  struct Value
  {
    double across, along;
  };
  // At a place x [m], z = 0 in two dimensions, beside this material.
  using Function = std::function<Value(std::array<double, 3> const& x, Material const& beside)>;

  std::string boundary;
  Against against;
  Function value;
  bool absorbs_waves = false; // and so has no meaning for a body without inertia
};

// The blocks of a boundary, lumped at its nodes, with the material beside each facet. InputError,
// maybe on one rank alone, where a value is negative or not finite.
template <int Dim>
NodalDampers resistanceOf(Mesh<Dim> const& mesh, BoundaryResistance const& resistance,
                          NodalFrames const& frames, std::vector<Material> const& materials);

// An absorbing boundary (Lysmer & Kuhlemeyer 1969), which absorbs plane waves at normal incidence:
// tractions -rho cp v_n and -rho cs v_t (antiplane: -rho cs v).
BoundaryResistance absorbingBoundary(std::string const& boundary);

// The traction eta V = eta factor v_t of radiation damping on a fault, lumped like friction.
// eta(num_nodes) [Pa s/m].
NodalDampers radiationDampers(FaultSurface const& fault, DofMap const& dofs,
                              std::vector<double> const& eta);

// Adds to a load the radiation damping of the plate rate, -eta Vp, lumped like friction: together
// with the dampers above, the traction is eta (factor v_t + Vp). eta(num_nodes) [Pa s/m].
void addRadiationOfPlates(FaultSurface const& fault, std::vector<double> const& eta, Vector& load);

// A copy of a matrix of assembleBody with the dampers, or springs, added.
RCP<const CrsMatrix> withDampers(CrsMatrix const& viscosity, DofMap const& dofs,
                                 NodalDampers const& dampers);

// A matrix of zeros on the same graph.
RCP<const CrsMatrix> zeroLike(CrsMatrix const& matrix);
// A copy with the same maps and the entries that are not zero; the matrix itself if these are more
// than half of those stored. Collective.
RCP<const CrsMatrix> withoutZeros(RCP<const CrsMatrix> const& matrix);
} // namespace asperity::fem
