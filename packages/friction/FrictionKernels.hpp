#pragma once

#include "friction/Types.hpp"
#include "portability/DenseSystem.hpp"

namespace asperity::friction
{
// The nodal friction functional (Pipping 2014, §4) with one law at every node of the fault,
//
//   psi_i(w) = weight_i [ sigma_n_i mubar(chi_i |w|, alpha_i) / chi_i + cohesion_i |w| ],
//
// where mubar(V, alpha) is the integral of mu(., alpha) from 0 to V, and chi_i is the slip factor.
// Hence
//
//   d psi_i / d|w| = weight_i [ sigma_n_i mu(chi_i |w|, alpha_i) + cohesion_i ].
//
// psi_i is a power in W, in two dimensions per metre of thickness.
//
// All views lie on the device, velocities are in m/s, and T is 1 or 2 (else std::invalid_argument).
// The kernels run in the default instance of ExecutionSpace; those that return a number have
// finished when they return. They allocate nothing. A caller that launches often should keep views
// of exactly the types named here, since the conversion to a view of constant values counts
// references.
class FrictionKernels
{
public:
  struct Difference
  {
    double change;    // sum of psi_i(v_i + d_i) - psi_i(v_i)
    double magnitude; // sum of its terms' magnitudes, also of log V: the scale of its rounding
  };

  virtual ~FrictionKernels() = default;

  // For each node i of `nodes`: v_i := argmin_w curvature_i/2 |w|^2 - <r_i, w> + psi_i(w).
  //
  // The minimiser is a multiple of r_i. Its length s solves
  //   curvature_i s + weight_i (sigma_n_i mu(chi_i s) + cohesion_i) = |r_i|
  // up to the rounding of this equation; s = 0 if |r_i| <= weight_i cohesion_i, or if the slip rate
  // would be below 1e-300 m/s. The given v_i is the first guess.
  // Beside a prescribed velocity p (StateAndStress) it minimises psi_i(w + p) instead: r_i is at
  // right angles to p, and s solves the equation with mu(chi_i |w + p|) and the part s / |w + p| of
  // friction.
  // curvature(num_nodes) > 0 in N s/m, r(num_nodes, T) in N.
  // Returns the number of nodes without a solution, where v_i does not change. There a curvature is
  // not positive, a value is not finite, or the iteration does not converge.
  virtual int minimise(IndexView const& nodes, ConstNodeView const& curvature,
                       ConstBlockView const& r, StateAndStress const& at,
                       BlockView const& v) const = 0;

  // A sweep of Gauss-Seidel in one launch: for each node i of `nodes`, one after the other,
  // minimises as above with the force r_i + curvature_i v_i, zero in held components, and subtracts
  // Z times the change of v_i from r, so that r remains b - Z v. If the system has bounds, its
  // blocks and v have one component more than r and v elsewhere: friction does not depend on the
  // last one, whose minimiser is that of the quadratic part, moved into its bounds.
  virtual int sweep(IndexView const& nodes, DenseSystem const& coupled, StateAndStress const& at,
                    BlockView const& v) const = 0;

  // Gradient [N] and Hessian [N s/m] of psi_i at v_i. kinked_i = 1 where psi_i has no second
  // derivative (v_i = 0 with cohesion, the kink of a law) or an infinite one: there the Hessian is
  // set to zero, and the gradient is the subgradient of least norm.
  virtual void linearise(ConstBlockView const& v, StateAndStress const& at,
                         BlockView const& gradient, HessianView const& hessian,
                         FlagView const& kinked) const = 0;

  // Sum over all nodes of the one-sided directional derivative psi_i'(v_i + t d_i; d_i).
  virtual double slope(ConstBlockView const& v, ConstBlockView const& d, double t,
                       StateAndStress const& at) const = 0;

  // Sum over all nodes of psi_i(v_i + d_i) - psi_i(v_i), from the integral of mu between the two.
  virtual Difference difference(ConstBlockView const& v, ConstBlockView const& d,
                                StateAndStress const& at) const = 0;

  // mu_i := mu(chi_i |v_i|, alpha_i).
  virtual void coefficient(ConstBlockView const& v, ConstNodeView const& alpha,
                           NodeView const& mu) const = 0;

  // alpha_i := the state at which mu(V_i, alpha_i) = mu_i, the law solved for its state.
  // V(num_nodes) in m/s, mu(num_nodes). Returns the number of nodes without such a state, where
  // alpha_i is left alone. There V_i or mu_i is not positive, or friction does not depend on the
  // state (b = 0).
  virtual int stateFor(ConstNodeView const& V, ConstNodeView const& mu,
                       NodeView const& alpha) const = 0;
};
} // namespace asperity::friction
