#pragma once

#include "tnnmg/NodalProblem.hpp"

#include <vector>

namespace asperity::tnnmg::test
{
// psi(v) = threshold |v| + strength m(|v|), m(0) = 0, m'(V) = asinh(V / scale): a kink at rest, and
// a resistance that grows like a logarithm.
struct Roughness
{
  double threshold = 0; // N
  double strength = 0;  // N
  double scale = 1;     // m/s

  // psi'(V) for V > 0.
  template <class Real>
  Real resistance(Real V) const;

  // The minimiser of curvature/2 s^2 - r s + psi(s) among s >= 0, to the last digit.
  template <class Real>
  Real minimiser(Real curvature, Real r) const;
};

// A nodal problem for Tnnmg. Its loops run on the host.
class RoughNodes : public NodalProblem
{
public:
  explicit RoughNodes(std::vector<Roughness> nodes) : nodes_(std::move(nodes)) {}

  int minimise(IndexView const& nodes, ConstNodeView const& curvature, ConstBlockView const& r,
               BlockView const& v) const override;
  int sweep(IndexView const& nodes, DenseSystem const& system, BlockView const& v) const override;
  void linearise(ConstBlockView const& v, BlockView const& gradient, HessianView const& hessian,
                 FlagView const& kinked) const override;
  double slope(ConstBlockView const& v, ConstBlockView const& d, double t) const override;
  EnergyChange difference(ConstBlockView const& v, ConstBlockView const& d) const override;

private:
  std::vector<Roughness> nodes_;
};
} // namespace asperity::tnnmg::test
