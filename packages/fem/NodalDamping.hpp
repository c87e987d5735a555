#pragma once

#include "base/Types.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "fem/dofs/DofMap.hpp"
#include "mesh/Mesh.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::fem
{
// Dampers of owned nodes: blocks in nodal frames, row-major in the leading components x components
// entries [N s/m, in 2D per metre], by the nodes of their rows and columns. The two nodes differ
// only at the pair of a split vertex. The matrix of all blocks is symmetric.
using NodalDampers = std::map<std::pair<int, int>, std::array<double, 9>>;

// The dampers of an absorbing boundary (Lysmer & Kuhlemeyer 1969), which absorbs plane waves at
// normal incidence: tractions -rho cp v_n and -rho cs v_t (antiplane: -rho cs v) with the
// material beside each facet, lumped at its nodes.
template <int Dim>
NodalDampers absorbingBoundary(Mesh<Dim> const& mesh, std::string const& boundary,
                               NodalFrames const& frames, std::vector<Material> const& materials);

// The traction eta V = eta factor v_t of radiation damping on a fault, lumped like friction.
// eta(num_nodes) [Pa s/m].
NodalDampers radiationDampers(FaultSurface const& fault, DofMap const& dofs,
                              std::vector<double> const& eta);

// Adds to a load the radiation damping of the plate rate, -eta Vp, lumped like friction: together
// with the dampers above, the traction is eta (factor v_t + Vp). eta(num_nodes) [Pa s/m].
void addRadiationOfPlates(FaultSurface const& fault, std::vector<double> const& eta, Vector& load);

// A copy of a matrix of assembleBody with the dampers added.
RCP<const CrsMatrix> withDampers(CrsMatrix const& viscosity, DofMap const& dofs,
                                 NodalDampers const& dampers);

// A matrix of zeros on the same graph.
RCP<const CrsMatrix> zeroLike(CrsMatrix const& matrix);
// A copy with the same maps and the entries that are not zero; the matrix itself if these are more
// than half of those stored. Collective.
RCP<const CrsMatrix> withoutZeros(RCP<const CrsMatrix> const& matrix);
} // namespace asperity::fem
