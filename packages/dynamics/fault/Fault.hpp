#pragma once

#include "dynamics/fault/FrictionInput.hpp"
#include "dynamics/fault/NormalStress.hpp"
#include "fem/FaultSurface.hpp"
#include "friction/FrictionKernels.hpp"
#include "friction/StateKernels.hpp"
#include "friction/Table.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::dynamics
{
// The laws at the nodes of a fault, with their parameters in the order of the laws' tables.
struct FaultLaws
{
  std::string friction;
  friction::ParameterView friction_parameters; // (num_parameters, num_nodes)
  ConstNodeView cohesion;                      // (num_nodes) [Pa]
  std::string state;
  friction::ParameterView state_parameters; // (num_parameters, num_nodes)
  // (num_nodes) traction per slip rate [Pa s/m] of a quasi-dynamic body; empty if there is none.
  std::vector<double> radiation_damping = {};
  // c / b of Linker and Dieterich's term, d(alpha) = -(c / b) d(ln sigma_n): (num_nodes) [-];
  // a view without entries means none.
  ConstNodeView stress_sensitivity = {};
  FaultProcesses processes = {};
  friction::TableView state_table = {}; // if the state law has one
  // What gives friction a normal stress that follows the one which the processes leave, as
  // RegularisedStress.hpp does; null if friction takes that one at once.
  std::shared_ptr<const FaultProcess> regularisation = {};
};

// What acts on a fault: friction, the evolution of its state, and the normal stress, at the nodes
// of its surface. Nothing in it changes during a run.
class Fault
{
public:
  // Throws what makeFrictionKernels and makeStateKernels throw.
  Fault(std::shared_ptr<const fem::FaultSurface> surface, FaultLaws laws,
        NormalStress normal_stress);

  fem::FaultSurface const& surface() const { return *surface_; }
  FaultLaws const& laws() const { return laws_; }
  NormalStress const& normalStress() const { return normal_stress_; }
  friction::FrictionKernels const& friction() const { return *friction_; }
  friction::StateKernels const& state() const { return *state_; }

  // Whether some node slides under friction that depends on a state. Then the error of that state
  // measures the error of a step; otherwise the motion of the body has to.
  bool stateDecides() const;

  // All processes in the order in which they act: those of the laws, then the regularisation.
  FaultProcesses const& processes() const { return processes_; }

  // What friction depends on in a state: its alpha and sigma_n, or what all processes make of them.
  // If there are processes, each call allocates memory, so that the result stays valid; iterations
  // of a step keep a FrictionInput instead. The same holds for effectiveStress().
  friction::StateAndStress given(State const& state) const
  {
    return FrictionInput(processes_, surface_->numNodes()).at(state);
  }
  // The normal stress (num_nodes) [Pa] less the pressure of fluids, before it is regularised.
  ConstNodeView effectiveStress(State const& state) const
  {
    return FrictionInput(laws_.processes, surface_->numNodes()).at(state).sigma_n;
  }

  // Friction kernels of the same law with another cohesion(num_nodes) [Pa].
  std::unique_ptr<friction::FrictionKernels> frictionWith(ConstNodeView const& cohesion) const;

private:
  std::shared_ptr<const fem::FaultSurface> surface_;
  FaultLaws laws_;
  NormalStress normal_stress_;
  FaultProcesses processes_;
  std::unique_ptr<friction::FrictionKernels> friction_;
  std::unique_ptr<friction::StateKernels> state_;
};
} // namespace asperity::dynamics
