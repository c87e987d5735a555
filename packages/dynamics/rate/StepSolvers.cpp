#include "dynamics/rate/StepSolvers.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"

#include <chrono>

namespace asperity::dynamics
{
namespace
{
// With multigrid a step size is set up in the time of a fraction of a step. A control alternates
// between a size, its half and its double; more would only take memory.
constexpr std::size_t most_with_multigrid = 3;
} // namespace

StepSolvers::StepSolvers(Body const& body, fem::FaultSurface const& surface,
                         RateUpdate const& update, DyadicTime const& clock,
                         RateSolverSettings const& settings, std::size_t budget_bytes,
                         std::shared_ptr<const NormalReaction> reaction)
    : body_(body)
    , surface_(surface)
    , update_(update)
    , clock_(clock)
    , settings_(settings)
    , reaction_(std::move(reaction))
    , budget_bytes_(budget_bytes)
{
}

void StepSolvers::forgetOldest()
{
  auto const oldest = solvers_.find(recent_.back());
  bytes_ -= oldest->second.bytes;
  solvers_.erase(oldest);
  recent_.pop_back();
}

RateSolver& StepSolvers::at(int level)
{
  recent_.remove(level);
  recent_.push_front(level);
  if (auto const known = solvers_.find(level); known != solvers_.end() && known->second.solver) {
    return *known->second.solver;
  }
  // Make room first, so that the old solver does not add to the peak of the memory.
  while (shared_ && recent_.size() > most_with_multigrid) {
    forgetOldest();
  }
  auto& [solver, bytes] = solvers_[level];
  ASPERITY_TIME_WORK("set-up of step sizes");
  auto const start = std::chrono::steady_clock::now();
  solver = setUp(level);
  // Set-ups are collective, so what is forgotten must not depend on a rank's share of the mesh.
  bytes = maxOverRanks(static_cast<std::int64_t>(solver->bytes()), *surface_.communicator());
  bytes_ += bytes;
  while (bytes_ > budget_bytes_ && recent_.size() > 1) {
    forgetOldest();
  }
  ++setups_;
  setup_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return *solver;
}

std::unique_ptr<RateSolver> StepSolvers::setUp(int level)
{
  const double tau = clock_.stepSize(level);
  auto const weights = update_.weights(tau, body_.matrices);
  const RCP<const CrsMatrix> across = reaction_ ? reaction_->rows(weights) : Teuchos::null;
  try {
    if (settings_.correction == Correction::multigrid && !shared_) {
      shared_.emplace(body_, surface_, settings_.multigrid);
    }
    auto const Z = fem::combine(body_.matrices, weights, body_.held);
    SharedSetup shared{{}, {}, &order_};
    if (shared_) {
      shared.terms = shared_->terms();
      shared.weights = shared_->weights(weights);
    }
    return makeRateSolver(Z, body_, surface_, settings_, across, shared);
  } catch (SolveError const& error) {
    throw SolveError("The solver for steps of " + formatShort(tau) +
                     " s (the largest step halved " + std::to_string(level) +
                     " times) could not be set up. " + error.what());
  }
}
} // namespace asperity::dynamics
