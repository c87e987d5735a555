#include "scenario/run/Evolution.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/checks/PlausibleValues.hpp"
#include "dynamics/control/NotFinite.hpp"
#include "mesh/BoundingBox.hpp"
#include "mesh/PointText.hpp"
#include "scenario/checks/SmallestStep.hpp"
#include "scenario/checks/StartCheck.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/TimeSchemes.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/watches/SkippedTimes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace asperity::scenario
{
namespace
{
template <int Dim>
std::unique_ptr<dynamics::CoupledStep> makeCoupledStep(Problem<Dim> const& problem,
                                                       dynamics::Model const& model,
                                                       dynamics::DyadicTime const& clock)
{
  auto const& time = problem.settings.time;
  const dynamics::StepSettings settings = {
    makeRateUpdate(time, !problem.settings.bulk.isQuasiDynamic()), clock, problem.settings.coupling,
    problem.solver, problem.settings.solver.memoryBudget()};
  return std::make_unique<dynamics::CoupledStep>(model.body, model.fault, settings, model.reaction);
}
} // namespace

template <int Dim>
dynamics::DyadicTime clockOf(Problem<Dim> const& problem)
{
  return makeClock(problem.settings.time, smallestStep(problem));
}

template dynamics::DyadicTime clockOf(Problem<2> const&);
template dynamics::DyadicTime clockOf(Problem<3> const&);

namespace
{
// Below which no error of displacement [m] and velocity [m/s] matters. Strainmeters resolve a
// hundred times that strain; a velocity over c_s, ten times the largest slip rate that is
// plausible, is a strain, too.
template <int Dim>
std::array<double, 2> leastMotion(Problem<Dim> const& problem)
{
  constexpr double least_strain = 1e-12;
  auto const sides = mesh::sidesOfBox<Dim>(problem.mesh().vertices, *problem.communicator);
  return {least_strain * *std::max_element(sides.begin(), sides.end()),
          least_strain * 10 * problem.findings.largest_slip_rate};
}
} // namespace

template <int Dim>
Evolution<Dim>::Evolution(Problem<Dim> const& problem, ParameterList const& deck,
                          Beginning const& beginning)
    : communicator_(problem.communicator)
    , problem_(problem)
    , condensation_(makeCondensation(problem_))
    , model_(condensation_ ? condensation_->model() : problem_.model)
    , clock_(clockOf(problem_))
    , end_(clock_.reaching(problem_.settings.time.final_time))
    , coupled_step_(makeCoupledStep(problem_, model_, clock_))
    , control_(makeStepControl(problem_.settings.time, problem_.settings.output_times,
                               *coupled_step_,
                               {problem_.scales.waveRate(), model_.initial.u, leastMotion(problem_),
                                [this](int vertex) { return placeOf(vertex); }}))
    , balance_(model_.body, model_.fault, clock_, model_.reaction)
    , state_(model_.initial.clone())
    , sample_(model_.fault.surface(), *model_.initial.u)
    , floor_count_(model_.fault)
    , watches_(makeWatches(deck))
{
  view_.state = &state_;
  view_.fault = &sample_;
  if (condensation_) {
    view_.condensation = condensation_.get();
    view_.recovery_rows = std::make_shared<dynamics::RecoveryRows>(*condensation_);
  }
  view_.floor_count = &floor_count_;
  view_.balance = &balance_;
  if (beginning.from == Beginning::From::checkpoint) {
    restore(beginning.archive);
    return;
  }
  if (beginning.from == Beginning::From::other_run) {
    state_ = WholeBodyArchive(problem_.model, condensation_.get(), clock_)
               .load(beginning.archive, "state");
  }
  beginBalance();
}

template <int Dim>
dynamics::Watches Evolution<Dim>::makeWatches(ParameterList const& deck) const
{
  auto const across =
    condensation_ ? condensation_->reactionFrom(problem_.across) : problem_.across;
  auto const places = placesOfLoads(problem_);
  auto const& scales = problem_.scales;
  return dynamics::Watches(deck.sublist(deck_lists::time),
                           {model_.body, model_.fault, across, deck,
                            problem_.settings.time.tolerance, control_->adapts(), scales.zone,
                            scales.weakening, scales.slipDistance(), scales.slowRate(),
                            problem_.findings.largest_slip_rate, places});
}

template <int Dim>
void Evolution<Dim>::beginBalance()
{
  balance_.start(state_);
  sample_.begin(state_, time(), balance_);
  auto const warnings = warnOfStart(balance_.startImbalance(), balance_.startContradiction());
  notes_.warnings.insert(notes_.warnings.end(), warnings.begin(), warnings.end());
}

template <int Dim>
void Evolution<Dim>::restore(Archive const& checkpoint)
{
  const auto level = static_cast<int>(checkpoint.getInteger("finest_level"));
  const WholeBodyArchive states(problem_.model, condensation_.get(), clock_, level);
  state_ = states.load(checkpoint, "state");
  control_->restore(checkpoint.child("control"), states);
  if (level != clock_.finestLevel()) {
    control_->adaptToClock();
  }
  count_ = loadMembers<dynamics::SolveCount>(checkpoint, "count");
  forced_steps_ = checkpoint.getInteger("forced_steps");
  floor_count_.restore(checkpoint.child("normal_stress_floor"));
  watches_.restore(checkpoint, {level < clock_.finestLevel()});
  if (numSteps() == 0) {
    beginBalance();
  } else {
    balance_.resume(state_, loadMembers<dynamics::Energy>(checkpoint, "energy"));
    sample_.begin(state_, time(), balance_);
  }
}

template <int Dim>
void Evolution<Dim>::save(Archive& checkpoint) const
{
  const WholeBodyArchive states(problem_.model, condensation_.get(), clock_);
  states.save(checkpoint, "state", state_);
  Archive control;
  control_->save(control, states);
  checkpoint.insert("control", std::move(control));
  saveMembers(checkpoint, "count", count_);
  saveMembers(checkpoint, "energy", balance_.energy());
  checkpoint.set("forced_steps", forced_steps_);
  checkpoint.set("finest_level", clock_.finestLevel());
  checkpoint.insert("normal_stress_floor", floor_count_);
  watches_.save(checkpoint);
}

template <int Dim>
void Evolution<Dim>::advance()
{
  auto const before = count_;
  rate_before_ = sample_.peakSlipRate();
  view_.step = control_->advance(state_, count_);
  view_.count = count_.since(before);
  has_stepped_ = true;
}

template <int Dim>
void Evolution<Dim>::updateTotals()
{
  requireFinite();
  forced_steps_ += view_.step.within_tolerance ? 0 : 1;
  {
    ASPERITY_TIME_WORK("energy balance");
    balance_.advance(state_);
  }
  sample_.begin(state_, time(), balance_);
  floor_count_.add(state_);
}

template <int Dim>
io::StepInfo Evolution<Dim>::stepInfo() const
{
  io::StepInfo info;
  info.step = numSteps();
  info.time = time();
  info.step_size = info.step > 0 ? clock_.stepSize(view_.step.level) : 0;
  info.peak_slip_rate = sample_.peakSlipRate();
  info.is_last = atEnd();
  return info;
}

template <int Dim>
void Evolution<Dim>::watch()
{
  dynamics::WatchedState now{state_, sample_, balance_.force(), count_.energy_increases,
                             time(), {}};
  if (has_stepped_) {
    auto const& step = view_.step;
    const bool is_smallest =
      control_->adapts() && clock_.finestLevel() > 0 && step.level == clock_.finestLevel();
    now.step = {clock_.stepSize(step.level), rate_before_, !step.within_tolerance, is_smallest,
                clock_.seconds(end_ - state_.time)};
  }
  watches_.note(now, notes_);
}

template <int Dim>
RunSummary Evolution<Dim>::summary() const
{
  RunSummary summary;
  summary.dimension = Dim;
  summary.time = time();
  summary.num_steps = numSteps();
  summary.forced_steps = forced_steps_;
  summary.count = count_;
  summary.floor_report = floor_count_.report();
  summary.watch_report = watches_.report();
  summary.energy = balance_.energy();
  summary.setups = coupled_step_->solvers().setups();
  summary.setup_seconds = coupled_step_->solvers().setupSeconds();
  return summary;
}

template <int Dim>
int Evolution<Dim>::numEliminated() const
{
  return condensation_ ? condensation_->numEliminated() : 0;
}

// The place of a vertex of the model, for messages. The vertices of a condensed model are the nodes
// of the fault, followed by those that stand for the motion of the boundaries.
template <int Dim>
std::string Evolution<Dim>::placeOf(int vertex) const
{
  if (condensation_ && vertex >= problem_.surface().numNodes()) {
    return "the boundaries that move";
  }
  vertex = condensation_ ? problem_.surface().vertex(vertex) : vertex;
  return "node " + std::to_string(problem_.mesh().global_ids[vertex]) + ", " +
         mesh::text(problem_.mesh().vertices[vertex]);
}

// Checks the step that has just been made: nan spreads quickly, and its first place is the most
// useful one.
template <int Dim>
void Evolution<Dim>::requireFinite() const
{
  const auto found = dynamics::firstNotFinite(state_);
  if (maxOverRanks(found ? 1 : 0, *communicator_) == 0) {
    return;
  }
  onEveryRank(*communicator_, [&] {
    if (!found) {
      return;
    }
    const int vertex = found->vertexIn(model_.body, model_.fault.surface());
    std::ostringstream message;
    message << "Step " << numSteps() << ", t = " << formatShort(time()) << " s: " << found->field
            << " is " << found->value << " at " << placeOf(vertex);
    message << ". Check loads, moduli and friction there. Checkpoints are of earlier steps.";
    throw SolveError(message.str());
  });
}

template class Evolution<2>;
template class Evolution<3>;
} // namespace asperity::scenario
