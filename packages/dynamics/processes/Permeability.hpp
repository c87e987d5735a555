#pragma once

#include "dynamics/FaultProcess.hpp"
#include "parameters/Parameters.hpp"

#include <memory>
#include <vector>

namespace asperity::dynamics
{
// How the permeability k of a fault changes: with the effective normal stress, and with slip, which
// raises it, and time, in which it heals (Zhu, Allison, Dunham & Yang 2020,
// doi:10.1038/s41467-020-18598-z):
//
//   k = k' exp(-(sigma_eff - sigma_ref) / sigma_k)
//   dk'/dt = -(V / L_k) (k' - k_max) - (k' - k_min) / T_k
//
// k' is a field of the state if it changes. Its flow is exact at the mean slip rate of a step and
// stays within k_min and k_max.
class Permeability
{
public:
  static void declare(Declare& process);

  // parameters: those of the process that the context describes. start(num_nodes): k' at the start
  // [m^2]. Throws InputError, maybe on one rank alone.
  Permeability(Teuchos::ParameterList const& parameters, FaultProcessContext const& context,
               std::vector<double> start);

  bool dependsOnStress() const { return !stress_scale_.empty(); }
  bool changes() const { return evolution_ || dependsOnStress(); }

  std::vector<State::Added> fields() const;
  std::vector<std::shared_ptr<StepUnknown>> unknowns() const;

  // k(num_nodes) [m^2] at a time tau [s] after the state, where the pressure is p(num_nodes); to
  // first order, since the slip rate and the normal stress are those of the state.
  std::vector<double> after(State const& state, double tau, ConstNodeView const& p) const;

private:
  class Evolution;

  std::vector<double> start_, stress_scale_, reference_stress_;
  std::shared_ptr<Evolution> evolution_;
};
} // namespace asperity::dynamics
