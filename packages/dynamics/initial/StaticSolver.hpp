#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/rate/RateSolver.hpp"

#include <memory>

namespace asperity::tnnmg
{
class SchurComplement;
} // namespace asperity::tnnmg

namespace asperity::dynamics
{
// Static problems of a body: K u = load at the free dofs and u = 0 at the held ones (Pipping 2014,
// §5.2), where K has the stiffness of all Maxwell branches. The fault slides without friction along
// its tangents that are not held.
class StaticSolver
{
public:
  // Keeps a factor of K, or a multigrid hierarchy. Collective.
  StaticSolver(Body body, RateSolverSettings const& settings);
  ~StaticSolver();

  // Throws SolveError if the body is not held. Collective.
  RCP<Vector> solve(Vector const& load);

private:
  Body body_;
  RCP<const CrsMatrix> K_;
  std::unique_ptr<const tnnmg::SchurComplement> factor_;
  std::unique_ptr<tnnmg::MultigridCorrection> multigrid_; // null with a factor
};
} // namespace asperity::dynamics
