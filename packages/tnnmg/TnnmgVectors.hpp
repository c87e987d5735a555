#pragma once

#include "tnnmg/RateMatrix.hpp"

#include <Tpetra_Vector.hpp>

// The vectors of a TNNMG iteration, and the arithmetic on them that does not involve psi.
namespace asperity::tnnmg::detail
{
// Values at the nonlinear nodes.
struct TnnmgBlocks
{
  explicit TnnmgBlocks(NonlinearNodes const& nodes);

  void differenceTo(BlockView const& reference,
                    BlockView const& result) const; // result = v - reference
  void scaleChange(double step) const;              // scaled = step * d
  // Truncates the nodes at a kink, those that are held in all components and those whose
  // Hessian exceeds stiff * curvature. Sets the held components of all Hessians to zero.
  void truncate(NonlinearNodes const& nodes, ConstNodeView const& curvature, double stiff) const;

  BlockView v, before, d, scaled, residual, gradient;
  HessianView hessian;
  FlagView truncated;
};

struct TnnmgVectors
{
  explicit TnnmgVectors(RateMatrix const& Z);

  // Keeps copies of b and of the first guess.
  void begin(Vector const& b, Vector const& guess);
  void beginIteration();
  // Returns 1 if J rose in the sweeps, which changed v by blocks.d, else 0. nonlinear: this rank's
  // part of the change of psi. Collective.
  int increasesInSweeps(RateMatrix const& Z, TnnmgBlocks const& blocks,
                        EnergyChange const& nonlinear) const;
  // This rank's part of the sum of the magnitudes of all terms of <Z u - b, x>, where
  // r_of_u = b - Z u. The magnitudes that the other functions estimate are too small where the
  // terms of a row cancel that has next to no velocity itself. As costly as a product with Z;
  // collective.
  double magnitudeOfTerms(RateMatrix const& Z, Vector const& u, Vector const& r_of_u,
                          Vector const& x) const;
  // newton_residual = b - Z v - gradient, zero in the held components of nonlinear nodes
  void newtonResidual(NonlinearNodes const& nodes, ConstBlockView const& gradient);

  struct Along
  {
    double start;     // <Z v - b, c>
    double curvature; // <Z c, c>
    double magnitude; // of the terms of start, estimated
  };
  // This rank's part of the derivative of J's quadratic part along the correction. One product
  // with Z.
  Along derivativeAlongCorrection(RateMatrix const& Z);
  void move(double step); // v += step c

  struct Norms
  {
    double change = 0, v = 0; // of v - v_before and of v in the norm of Z
    int failed_nodes = 0;     // on any rank
  };
  // Collective.
  Norms norms(int failed_nodes) const;

  RCP<Vector> v_columns, v; // v is the owned part of v_columns
  Vector b, v_before, r, r_before, newton_residual, c, Zc;
};
} // namespace asperity::tnnmg::detail
