#pragma once

#include "dynamics/DyadicTime.hpp"
#include "dynamics/RateUpdate.hpp"
#include "dynamics/fault/NormalReaction.hpp"
#include "dynamics/rate/RateSolver.hpp"
#include "dynamics/rate/SharedMultigrid.hpp"

#include <list>
#include <map>
#include <memory>
#include <optional>

namespace asperity::dynamics
{
// One solver for each step size: Z (RateUpdate::weights) depends on nothing else. A solver is set
// up when it is first used; the least recently used ones are removed when the memory budget of a
// rank is exceeded, and with multigrid, whose solvers share what is costly to make, beyond the last
// three. All ranks remove the same ones: on every rank a solver counts with the memory of the rank
// where it takes most. With a reaction the solvers know Z's rows across the fault, see
// RateSolver::reactions.
class StepSolvers
{
public:
  StepSolvers(Body const& body, fem::FaultSurface const& surface, RateUpdate const& update,
              DyadicTime const& clock, RateSolverSettings const& settings, std::size_t budget_bytes,
              std::shared_ptr<const NormalReaction> reaction = nullptr);

  // The reference is valid until the next call. Collective.
  RateSolver& at(int level);

  int setups() const { return setups_; }
  double setupSeconds() const { return setup_seconds_; }
  std::size_t bytes() const { return bytes_; } // the same on all ranks

private:
  struct Kept
  {
    std::unique_ptr<RateSolver> solver;
    std::size_t bytes = 0;
  };

  void forgetOldest();
  std::unique_ptr<RateSolver> setUp(int level); // throws SolveError; collective

  Body const& body_;
  fem::FaultSurface const& surface_;
  RateUpdate update_;
  DyadicTime clock_;
  RateSolverSettings settings_;
  std::shared_ptr<const NormalReaction> reaction_;
  std::optional<SharedMultigrid> shared_; // made with the first solver, if multigrid
  tnnmg::EliminationOrder order_;         // of the direct correction, that of all step sizes
  std::size_t budget_bytes_;
  std::size_t bytes_ = 0;
  std::map<int, Kept> solvers_;
  std::list<int> recent_; // levels, the last used one first
  int setups_ = 0;
  double setup_seconds_ = 0;
};
} // namespace asperity::dynamics
