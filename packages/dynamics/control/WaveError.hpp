#pragma once

#include "dynamics/RateUpdate.hpp"
#include "dynamics/fault/FaultMotion.hpp"

namespace asperity::dynamics
{
// How errors of waves count in a step control.
struct WaveScale
{
  double slip_rate = 0; // b sigma_n / Z [m/s] with the shear impedance Z; 0: they do not count
  double weight = 1;
};

// The error of velocity that steps leave in the body, where no step is compared with others. It
// follows from accelerations a and jerks j at both ends of one step, or of several of the same size
// tau, for a scheme of order p with the constant c = RateUpdate::velocity_error
// (compare Zienkiewicz and Xie 1991):
//
//   e = c tau (a1 - a0) (p = 1),   e = c tau^2 (j1 - j0) (p = 2)
//
// What counts is its largest component anywhere, chi |e| / S with the slip factor chi and
// S = b sigma_n / Z + V for the peak slip rate V. A wave of velocity e that arrives changes
// friction by about Z e. So where the fault is slow this is the change of alpha that would do the
// same, and where it is fast the relative error of V.
class WaveError
{
public:
  // body and surface must outlive this.
  WaveError(Body const& body, fem::FaultSurface const& surface, RateUpdate const& update,
            WaveScale const& scale);

  // weight chi |e| / S of steps of tau [s] that lead from one state to the other; 0 in a body
  // without mass. Collective.
  double errorBetween(State const& from, State const& to, double tau) const;

private:
  Body const& body_;
  fem::FaultSurface const& surface_;
  int order_;
  double constant_;
  WaveScale scale_;
  RCP<Vector> e_; // null where nothing counts
  BlockView w_;
  NodeView V_;
};
} // namespace asperity::dynamics
