#include "scenario/run/Evolution.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/checks/PlausibleValues.hpp"
#include "dynamics/control/NotFinite.hpp"
#include "io/OutputSet.hpp"
#include "mesh/PointText.hpp"
#include "scenario/report/ResolutionCheck.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace asperity::scenario
{
namespace
{
const std::string of_growth = "growth_watch/", of_stall = "stall_watch/",
                  of_front = "front_watch/"; // in a checkpoint
const std::string of_tension = "tension_watch";

// The longest side of the body along an axis [m].
template <int Dim>
double extentOf(Problem<Dim> const& problem)
{
  double longest = 0;
  for (int d = 0; d < Dim; ++d) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (auto const& vertex : problem.mesh.vertices) {
      low = std::min(low, vertex[d]);
      high = std::max(high, vertex[d]);
    }
    longest = std::max(longest, maxOverRanks(high, *problem.communicator) -
                                  minOverRanks(low, *problem.communicator));
  }
  return longest;
}
} // namespace

template <int Dim>
Evolution<Dim>::Evolution(ParameterList const& deck, RCP<const Communicator> const& communicator)
    : communicator_(communicator)
    , problem_(makeProblem<Dim>(deck, communicator))
    , condensation_(makeCondensation(problem_, deck))
    , model_(condensation_ ? condensation_->model() : problem_)
    , clock_(makeClock(deck.sublist("Time Stepping"), smallestStep(problem_, deck)))
    , end_(clock_.reaching(scenario::finalTime(deck.sublist("Time Stepping"))))
    , balance_(model_.body, model_.fault, clock_)
    , state_(model_.initial.clone())
    , sample_(model_.fault.surface(), *model_.initial.u)
    , format_(problem_, condensation_.get(), clock_)
    , floor_count_(model_.fault)
    , stall_watch_(deck.sublist("Time Stepping").get<int>("Most Forced Steps"))
    , tolerance_(stepTolerance(deck.sublist("Time Stepping")))
    , rate_to_tell_(problem_.largest_slip_rate)
    , pressure_watch_(model_.fault)
    , front_watch_(problem_.scales.zone, model_.fault)
    , tension_watch_(model_.body, model_.fault,
                     condensation_ ? condensation_->reactionFrom(problem_.across) : problem_.across)
    , skipped_times_(deck, placesOfLoads(problem_), problem_.communicator)
{
  auto const update =
    makeRateUpdate(deck.sublist("Time Stepping"), !quasiDynamic(deck.sublist("Bulk")));
  coupled_step_ = std::make_unique<dynamics::CoupledStep>(
    model_.body, model_.fault, update, clock_,
    dynamics::CouplingSettings::from(deck.sublist("Coupling"), tolerance_), problem_.solver,
    memoryBudget(deck.sublist("TNNMG")), model_.reaction);
  control_ =
    makeStepControl(deck.sublist("Time Stepping"), io::OutputSet::times(deck.sublist("Output")),
                    *coupled_step_, problem_.scales.waveRate());
  // Strainmeters resolve a hundred times that; a velocity over c_s, ten times the largest slip rate
  // that is plausible, is a strain, too.
  constexpr double least_strain = 1e-12;
  control_->setStart(model_.initial.u, least_strain * extentOf(problem_),
                     least_strain * 10 * problem_.largest_slip_rate);
  control_->setPlaces([this](int vertex) { return placeOf(vertex); });
  slow_slip_.emplace(problem_.scales.weakening, problem_.scales.slowRate());
  growth_watch_.emplace(problem_.scales.slipDistance(),
                        deck.sublist("Time Stepping").get<int>("Most Hiding Steps"),
                        !control_->adapts());
  view_.state = &state_;
  view_.fault = &sample_;
  if (condensation_) {
    view_.condensation = condensation_.get();
    view_.recovery_rows = std::make_shared<dynamics::RecoveryRows>(*condensation_);
  }
  view_.floor_count = &floor_count_;
  view_.balance = &balance_;
}

// An overstressed patch, or one that starts to slip against the load, is smaller.
constexpr double largest_contradiction = 0.5;
// Share of the forces at the start. The tolerance of solvers and the rounded numbers of a deck
// leave less; a state of one run under the loads of another, or a traction in other units, leaves
// far more.
constexpr double largest_imbalance = 0.01;

template <int Dim>
void Evolution<Dim>::beginBalance()
{
  balance_.start(state_);
  sample_.begin(state_, time(), balance_);
  const double imbalance = balance_.startImbalance();
  if (imbalance > largest_imbalance) {
    warnings_.push_back(
      {"start out of balance",
       "The run starts out of balance: " + formatShort(imbalance) +
         " of the forces are not balanced (at most " + formatShort(largest_imbalance) +
         " is usual). A quasi-dynamic body has no inertia, so that velocities and stresses jump in "
         "the first step, however small it is. Check Friction / Shear Traction, whose unit is Pa, "
         "or choose Initial State / State = Stress Balance."});
  }
  const double contradiction = balance_.startContradiction();
  if (contradiction > largest_contradiction) {
    warnings_.push_back(
      {"friction at the start",
       "At the start friction acts with the load instead of against it over " +
         formatShort(std::round(1000 * contradiction) / 10) +
         " % of the fault, which slips against its shear traction: the traction changes its sign "
         "in the first step, and the jump sets off waves. Check the signs of Friction / Shear "
         "Traction and of the velocity or slip rate under Initial State."});
  }
}

template <int Dim>
void Evolution<Dim>::start()
{
  beginBalance();
}

template <int Dim>
void Evolution<Dim>::startFrom(io::Archive const& state)
{
  state_ = format_.load(state, "state");
  start();
}

template <int Dim>
void Evolution<Dim>::restore(io::Archive const& checkpoint)
{
  state_ = format_.load(checkpoint, "state");
  control_->restore(format_.loadControl(checkpoint, "control"));
  const bool is_rescaled = checkpoint.getInteger("finest_level") != clock_.finestLevel();
  if (is_rescaled) {
    control_->adaptToClock();
  }
  count_ = loadSum<dynamics::SolveCount>(checkpoint, "count");
  forced_steps_ = checkpoint.getInteger("forced_steps");
  floor_count_.restore(checkpoint, "normal_stress_floor");
  restoreWatches(checkpoint);
  if (numSteps() == 0) {
    beginBalance();
  } else {
    balance_.resume(state_, loadSum<dynamics::Energy>(checkpoint, "energy"));
    sample_.begin(state_, time(), balance_);
  }
}

template <int Dim>
void Evolution<Dim>::save(io::Archive& checkpoint) const
{
  format_.save(checkpoint, "state", state_);
  format_.save(checkpoint, "control", control_->memory());
  saveSum(checkpoint, "count", count_);
  saveSum(checkpoint, "energy", balance_.energy());
  checkpoint.set("forced_steps", forced_steps_);
  checkpoint.set("finest_level", clock_.finestLevel());
  floor_count_.save(checkpoint, "normal_stress_floor");
  saveWatches(checkpoint);
}

template <int Dim>
void Evolution<Dim>::saveWatches(io::Archive& checkpoint) const
{
  checkpoint.set(of_growth + "least", growth_watch_->memory().least);
  checkpoint.set(of_growth + "forced", growth_watch_->memory().forced);
  checkpoint.set(of_growth + "others", growth_watch_->memory().others);
  checkpoint.set(of_growth + "damped", growth_watch_->memory().damped);
  checkpoint.set(of_growth + "tolerance", tolerance_);
  checkpoint.set(of_stall + "smallest", stall_watch_.memory().smallest);
  checkpoint.set(of_stall + "forced", stall_watch_.memory().forced);
  front_watch_.save(checkpoint, of_front);
  tension_watch_.save(checkpoint, of_tension);
}

// Counts go on, so that restarts do not escape the limits. What has been cured is counted anew:
// forced steps where the smallest step is smaller than before, others where the tolerance is. The
// largest step cannot change, so that levels tell sizes. Earlier versions save no watches.
template <int Dim>
void Evolution<Dim>::restoreWatches(io::Archive const& checkpoint)
{
  tension_watch_.restore(checkpoint, of_tension);
  if (!checkpoint.has(of_growth + "forced")) {
    return;
  }
  const bool has_smaller_steps = checkpoint.getInteger("finest_level") < clock_.finestLevel();
  dynamics::GrowthWatch::Memory growth;
  growth.others = checkpoint.getInteger(of_growth + "others");
  growth.damped =
    checkpoint.has(of_growth + "damped") ? checkpoint.getInteger(of_growth + "damped") : 0;
  if (tolerance_ < checkpoint.getDouble(of_growth + "tolerance")) {
    growth.others = growth.damped = 0;
  }
  dynamics::StallWatch::Memory stall;
  if (!has_smaller_steps) {
    growth.least = checkpoint.getDouble(of_growth + "least");
    growth.forced = checkpoint.getInteger(of_growth + "forced");
    stall.smallest = checkpoint.getInteger(of_stall + "smallest");
    stall.forced = checkpoint.getInteger(of_stall + "forced");
  }
  growth_watch_->restore(growth);
  stall_watch_.restore(stall);
  front_watch_.restore(checkpoint, of_front);
}

template <int Dim>
void Evolution<Dim>::advance()
{
  auto const before = count_;
  rate_before_ = sample_.peakSlipRate();
  view_.step = control_->advance(state_, count_);
  view_.count = count_.since(before);
}

template <int Dim>
void Evolution<Dim>::account()
{
  requireFinite();
  forced_steps_ += view_.step.within_tolerance ? 0 : 1;
  if (view_.count.rises > 0 && count_.rises >= rises_to_tell_) {
    rises_to_tell_ = 10 * count_.rises;
    warnings_.push_back(warnOfRises(count_.rises));
  }
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
std::string Evolution<Dim>::watchStall()
{
  dynamics::StallWatch::Step step;
  step.is_smallest =
    control_->adapts() && clock_.finestLevel() > 0 && view_.step.level == clock_.finestLevel();
  step.is_forced = !view_.step.within_tolerance;
  step.time = time();
  step.step_size = clock_.stepSize(view_.step.level);
  step.time_left = clock_.seconds(end_ - state_.time);
  return stall_watch_.note(step);
}

template <int Dim>
void Evolution<Dim>::watchGrowth()
{
  auto const info = stepInfo();
  std::optional<Warning> of_growth, of_ringing;
  if (model_.fault.stateDecides()) { // other slip rates grow and ring as a deck prescribes
    of_growth = growth_watch_->note(
      {!view_.step.within_tolerance, info.time, info.step_size, rate_before_, info.peak_slip_rate,
       slow_slip_->of(sample_.slipRates(), info.step_size, *communicator_)});
    of_ringing = ring_watch_.note(info.time, info.peak_slip_rate);
  }
  for (auto const& warning :
       {of_growth, of_ringing, skipped_times_.note(info.time - info.step_size, info.time)}) {
    if (warning) {
      warnings_.push_back(*warning);
    }
  }
}

template <int Dim>
void Evolution<Dim>::watchRate()
{
  const double rate = sample_.peakSlipRate();
  if (rate > rate_to_tell_) {
    rate_to_tell_ = 10 * rate;
    warnings_.push_back(dynamics::warnOfSlipRate(rate, problem_.largest_slip_rate));
  }
}

template <int Dim>
void Evolution<Dim>::watchTension()
{
  if (auto const warning = tension_watch_.note(balance_.force(), time())) {
    warnings_.push_back(*warning);
  }
}

template <int Dim>
void Evolution<Dim>::watchPressure()
{
  if (auto const warning = pressure_watch_.note(state_, time())) {
    warnings_.push_back(*warning);
  }
}

template <int Dim>
void Evolution<Dim>::watchFront()
{
  if (auto const warning = front_watch_.note(state_, sample_, time())) {
    warnings_.push_back(*warning);
  }
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
  summary.of_floor = floor_count_.report();
  summary.of_front = front_watch_.report();
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
  if (condensation_ && vertex >= problem_.surface->numNodes()) {
    return "the boundaries that move";
  }
  vertex = condensation_ ? problem_.surface->vertex(vertex) : vertex;
  return "node " + std::to_string(problem_.mesh.global_ids[vertex]) + ", " +
         mesh::text(problem_.mesh.vertices[vertex]);
}

// Checks the step that has just been made: nan spreads quickly, and the first place tells most.
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
