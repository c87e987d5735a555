#pragma once

namespace asperity
{
template <class T>
class Entries;
} // namespace asperity

namespace asperity::tnnmg
{
// When the iteration stops, and how much work one iteration does; read from the deck's list
// `TNNMG`.
struct TnnmgSettings
{
  double absolute_tolerance = 1e-8;  // of the error, in Z's norm [W^(1/2) m^(-1/2) in 2D]
  double relative_tolerance = 1e-10; // of the error, relative to the norm of v
  int max_iterations = 50;
  int sweeps = 1; // of Gauss-Seidel in each iteration
  // Relative residual of the linear correction. A smaller one costs V-cycles but saves no
  // iterations; a larger one costs iterations.
  double correction_tolerance = 1e-2;
  double stiff = 1e6; // a node whose Hessian exceeds this multiple of its curvature is truncated

  static Entries<TnnmgSettings> entries();
};
} // namespace asperity::tnnmg
