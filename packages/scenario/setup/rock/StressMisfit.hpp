#pragma once

#include "base/Warning.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "scenario/setup/NodalField.hpp"

#include <optional>
#include <vector>

namespace asperity::scenario
{
// A warning where the traction -sigma n of the rock beside the fault, by the deck's
// `Initial Stress`, differs by more than 1 % from the deck's `Shear Traction`(num_nodes, T) [Pa] or
// `Normal Stress` over more than half of where the fault slides beside rock that takes that stress;
// an overstressed patch is smaller. Both are evaluated at the nodes, so that they agree to rounding
// however coarse the mesh is. The normal stress counts if both lists give it, and not antiplane.
// bulk, friction: the lists of the deck. components: of the displacement. nodes: those of the
// surface. Collective.
template <int Dim>
std::optional<Warning>
warnOfStressAtStart(ParameterList const& bulk, ParameterList const& friction, int components,
                    Mesh<Dim> const& mesh, fem::YieldingRock const& rock, FieldNodes const& nodes,
                    fem::FaultSurface const& surface, std::vector<double> const& shear_traction);
} // namespace asperity::scenario
