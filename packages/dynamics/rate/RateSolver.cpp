#include "dynamics/rate/RateSolver.hpp"

#include "dynamics/rate/CondensedRateSolver.hpp"
#include "dynamics/rate/FullRateSolver.hpp"
#include "dynamics/rate/SharedMultigrid.hpp"

namespace asperity::dynamics
{
std::unique_ptr<RateSolver> makeRateSolver(RCP<const CrsMatrix> const& Z, Body const& body,
                                           fem::FaultSurface const& surface,
                                           RateSolverSettings const& settings,
                                           RCP<const CrsMatrix> const& reactions,
                                           SharedSetup const& shared)
{
  if (settings.correction == Correction::direct) {
    tnnmg::EliminationOrder own;
    return makeCondensedRateSolver(*Z, surface, settings.tnnmg, reactions,
                                   shared.order ? *shared.order : own);
  }
  auto const nodes = nodesOf(surface);
  auto const correction = std::make_shared<tnnmg::MultigridCorrection>(
    multigridProblem(Z, body, nodes), settings.multigrid, shared.terms, shared.weights);
  return makeFullRateSolver(Z, nodes, correction, settings.tnnmg, reactions);
}
} // namespace asperity::dynamics
