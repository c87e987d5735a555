#pragma once

#include "dynamics/observables/EnergyBalance.hpp"

#include <optional>
#include <vector>

namespace asperity::dynamics
{
// What a fault does at the end of a step, at its nodes and on the host, for all who read it: a
// quantity is computed when it is first read, and kept until the next step.
//
// Vectors have numComponents() entries for each node: in two dimensions the component along the
// tangent, in three those along the axes, since tangents change from node to node.
class FaultSample
{
public:
  using Values = std::vector<double>;

  // start(owned dofs): the displacement from which slip counts [m].
  FaultSample(fem::FaultSurface const& surface, Vector const& start);

  // Begins the sample of the state to which the balance has just advanced, at `time` [s]. Both must
  // stay as they are for as long as the sample is read.
  void begin(State const& state, double time, EnergyBalance const& balance);

  int numComponents() const;
  Values const& slipRate() const;        // (num_nodes) [m/s]
  ConstNodeView slipRates() const;       // the same where kernels run
  double peakSlipRate() const;           // [m/s], peakSlipRate of FaultMotion; collective
  Values const& alpha() const;           // (num_nodes)
  Values const& normalStress() const;    // (num_nodes) [Pa], positive in compression
  Values const& effectiveStress() const; // (num_nodes) [Pa], Fault::effectiveStress
  Values const& slip() const;            // (num_nodes, numComponents()) [m], with that of plates
  Values const& slipVelocity() const;    // (num_nodes, numComponents()) [m/s], with that of plates
  // On a fault that may open: the opening (num_nodes) [m], and the part of the fault's measure that
  // is open, which is collective.
  Values const& opening() const;
  double shareOpen() const;
  Values const& traction() const; // (num_nodes, numComponents()) [Pa], which friction bears

private:
  struct Quantities
  {
    std::optional<Values> slip_rate, alpha, normal_stress, effective_stress, slip, slip_velocity,
      traction, opening;
    std::optional<NodeView> V;
    std::optional<double> peak;
  };
  template <class Factor>
  Values written(ConstBlockView const& blocks, Factor const& factor) const;

  fem::FaultSurface const& surface_;
  BlockView start_; // (num_nodes, T) tangential components
  State const* state_ = nullptr;
  double time_ = 0;
  EnergyBalance const* balance_ = nullptr;
  mutable Quantities known_; // of this step
};
} // namespace asperity::dynamics
