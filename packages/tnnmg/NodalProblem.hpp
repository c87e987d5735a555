#pragma once

#include "portability/DenseSystem.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <limits>

namespace asperity::tnnmg
{
// A change of psi or J, and the sum of the magnitudes of the terms that add up to it.
struct EnergyChange
{
  double change = 0;
  double magnitude = 0;
  // 1 if the change is positive by more than rounding explains, that of each term and that of a sum
  // of num_terms terms one after the other (Higham 2002, (4.4)), else 0.
  int countsAsIncrease(double num_terms) const
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    return change > (10 + num_terms / 2) * epsilon * magnitude ? 1 : 0;
  }
};

// The nonlinearity psi_i, convex, of this rank's nonlinear nodes i. A host object, whose members
// launch kernels; they are called in each iteration and need not be called on all ranks together.
class NodalProblem
{
public:
  virtual ~NodalProblem() = default;

  // Beyond its bounds psi_i is infinite; psi_i is smooth in the last component between them. The
  // functions below are called for v and v + t d within the bounds alone. Bounds change with the
  // right side (Tnnmg::begin) alone.
  virtual Bounds bounds() const { return {}; }
  // v_i = argmin curvature_i/2 |w|^2 - <r_i, w> + psi_i(w) for the given nodes. Returns the number
  // of nodes where this failed.
  virtual int minimise(IndexView const& nodes, ConstNodeView const& curvature,
                       ConstBlockView const& r, BlockView const& v) const = 0;
  // The same for the given nodes one after the other, with the force r_i + curvature_i v_i, zero in
  // held components. r = b - Z v is kept up to date.
  virtual int sweep(IndexView const& nodes, DenseSystem const& system,
                    BlockView const& v) const = 0;
  // Gradient and Hessian of psi_i at v_i without its bounds; kinked_i = 1 where psi_i has no second
  // derivative. With bounds the last row and column of a Hessian are zero, and kinked_i is about
  // the other components.
  virtual void linearise(ConstBlockView const& v, BlockView const& gradient,
                         HessianView const& hessian, FlagView const& kinked) const = 0;
  // The sum of psi_i'(v_i + t d_i; d_i).
  virtual double slope(ConstBlockView const& v, ConstBlockView const& d, double t) const = 0;
  // The sum of psi_i(v_i + d_i) - psi_i(v_i), accurate for small d: an integral of psi', not the
  // difference of two values.
  virtual EnergyChange difference(ConstBlockView const& v, ConstBlockView const& d) const = 0;
};
} // namespace asperity::tnnmg
