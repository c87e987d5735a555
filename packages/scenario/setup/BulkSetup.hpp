#pragma once

#include "fem/OtherSide.hpp"
#include "fem/bulk/Material.hpp"
#include "scenario/setup/NodalField.hpp"

#include <array>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Bulk`.
RCP<const ParameterList> bulkParameters();

// Displacement components of the chosen model: 1 antiplane, 2 in plane strain, 3 of a solid.
int displacementComponents(ParameterList const& list);

// The same, but throws InputError unless the model fits a mesh of this dimension.
int displacementComponents(ParameterList const& list, int dimension);

// Whether the body has no mass, and its fault has radiation damping instead.
bool quasiDynamic(ParameterList const& list);

// Whether gravity acts on the body.
bool gravityActs(ParameterList const& list);

// The radiation damping eta [Pa s/m] at the nodes of a fault, traction per slip rate; zero unless
// quasi-dynamic. The default follows from the materials at_nodes(num_nodes) and the other side.
std::vector<double> radiationDamping(ParameterList const& list, FieldNodes const& nodes,
                                     fem::OtherSide const& other_side,
                                     std::vector<fem::Material> const& at_nodes);

// The gravitational acceleration along the axes [m/s^2]; zero without gravity. down: its direction
// if the list gives none.
template <int Dim>
std::array<double, Dim> gravity(ParameterList const& list,
                                std::array<double, 3> const& down = {0, -1, 0});
} // namespace asperity::scenario
