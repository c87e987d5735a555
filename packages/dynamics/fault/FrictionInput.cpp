#include "dynamics/fault/FrictionInput.hpp"

namespace asperity::dynamics
{
FrictionInput::FrictionInput(FaultProcesses processes, int num_nodes)
    : processes_(std::move(processes))
{
  if (!processes_.empty()) {
    alpha_ = NodeView("asperity::dynamics::givenAlpha", num_nodes);
    sigma_n_ = NodeView("asperity::dynamics::givenStress", num_nodes);
  }
}

friction::StateAndStress FrictionInput::at(State const& state) const
{
  if (processes_.empty()) {
    return {state.alpha, state.sigma_n};
  }
  Kokkos::deep_copy(alpha_, state.alpha);
  Kokkos::deep_copy(sigma_n_, state.sigma_n);
  for (auto const& process : processes_) {
    process->act(state, alpha_, sigma_n_);
  }
  return {alpha_, sigma_n_};
}
} // namespace asperity::dynamics
