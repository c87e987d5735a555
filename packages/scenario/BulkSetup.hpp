#pragma once

#include "base/Parameters.hpp"
#include "fem/Material.hpp"
#include "mesh/Mesh.hpp"

#include <array>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Bulk`.
RCP<const ParameterList> bulkParameters();

// Displacement components of the chosen model: 2 in plane strain, 1 antiplane.
int displacementComponents(ParameterList const& list);

// Whether the body has no mass, and its fault a radiation damping instead.
bool quasiDynamic(ParameterList const& list);

// The radiation damping eta [Pa s/m] at some nodes, per slip rate; zero unless quasi-dynamic.
// at_nodes(num_nodes): the material there, for its default.
std::vector<double> radiationDamping(ParameterList const& list, Mesh<2> const& mesh,
                                     std::vector<int> const& nodes,
                                     std::vector<fem::Material> const& at_nodes,
                                     double slip_factor);

// One material for each cell, from fields evaluated at its centroid.
std::vector<fem::Material> makeMaterials(ParameterList const& list, Mesh<2> const& mesh);

// Along x and y, m/s^2; zero without gravity.
std::array<double, 2> gravity(ParameterList const& list);
} // namespace asperity::scenario
