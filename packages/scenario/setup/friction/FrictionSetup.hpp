#pragma once

#include "base/Warning.hpp"
#include "dynamics/fault/Fault.hpp"
#include "scenario/setup/NodalField.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Friction`: the laws with their parameters, cohesion, normal stress and shear
// traction.
RCP<const ParameterList> frictionParameters();

// Its entries that are neither fields nor laws.
struct FrictionSettings
{
  double normal_stress_factor = 1;
  std::string change = "Fixed"; // of the normal stress
  double floor = 0;             // of the normal stress [Pa]
  std::vector<double> slip_direction = {1, 0, 0};

  static FrictionSettings from(ParameterList const& list);
};

// How the normal stress follows the body, and the floor that it does not fall below [Pa].
dynamics::NormalStressChange normalStressChange(ParameterList const& list);
double normalStressFloor(ParameterList const& list);
// Whether friction follows the compression that the body exerts without a delay of its own.
bool followsAtOnce(ParameterList const& list);

// Warnings about a friction coefficient and a reference slip rate that no material has anywhere on
// the fault. Collective.
std::vector<Warning> warnOfImplausibleFriction(ParameterList const& list, FieldNodes const& nodes,
                                               Communicator const& communicator);

// Makes the fault: the laws of the list with their parameters at the nodes, which are those of the
// surface and of its mesh, and the normal stress with the list's Normal Stress Change and Floor.
// body_presses: whether motion of the body presses across the fault; where it cannot, the normal
// stress does not follow it. radiation_damping(num_nodes) [Pa s/m], or empty. Throws InputError
// where the term of Linker and Dieterich (c > 0) is used with a normal stress that is or may become
// zero.
dynamics::Fault makeFault(ParameterList const& list, FieldNodes const& nodes,
                          std::shared_ptr<const fem::FaultSurface> const& surface,
                          std::shared_ptr<const fem::FaultMesh> const& mesh,
                          dynamics::NormalStress const& normal_stress, bool body_presses,
                          std::vector<double> const& radiation_damping = {});
} // namespace asperity::scenario
