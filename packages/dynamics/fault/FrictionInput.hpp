#pragma once

#include "dynamics/FaultProcess.hpp"
#include "friction/FrictionKernels.hpp"

namespace asperity::dynamics
{
using FaultProcesses = std::vector<std::shared_ptr<const FaultProcess>>;

// What friction depends on in a state: its alpha and sigma_n, or what processes make of them, one
// after the other. Its constructor allocates the memory, which has the values of one state at a
// time: keep one where at() is called in every iteration.
class FrictionInput
{
public:
  FrictionInput(FaultProcesses processes, int num_nodes);

  // The values are valid until the next call.
  friction::StateAndStress at(State const& state) const;

private:
  FaultProcesses processes_;
  NodeView alpha_, sigma_n_; // (num_nodes); without entries if there are no processes
};
} // namespace asperity::dynamics
