#pragma once

#include "base/Warning.hpp"
#include "dynamics/control/GrowthWatch.hpp"
#include "dynamics/control/RingWatch.hpp"
#include "dynamics/control/SlowSlip.hpp"
#include "dynamics/control/StallWatch.hpp"
#include "dynamics/coupling/CoupledStep.hpp"
#include "io/Output.hpp"
#include "scenario/Condensation.hpp"
#include "scenario/FloorCount.hpp"
#include "scenario/OutputFields.hpp"
#include "scenario/Problem.hpp"
#include "scenario/RunArchive.hpp"
#include "scenario/report/RunReport.hpp"
#include "scenario/run/FrontWatch.hpp"
#include "scenario/run/PressureWatch.hpp"
#include "scenario/run/SkippedTimes.hpp"
#include "scenario/run/TensionWatch.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::scenario
{
// The time stepping of a problem: its state, its steps, and the sums of energy, effort and nodes on
// the floor of the normal stress.
template <int Dim>
class Evolution
{
public:
  // `deck` must be complete. Throws SolveError if the state at the start cannot be computed.
  // Collective, as all that follows.
  Evolution(ParameterList const& deck, RCP<const Communicator> const& communicator);

  Problem<Dim> const& problem() const { return problem_; }
  dynamics::DyadicTime const& clock() const { return clock_; }
  RunView const& view() const { return view_; } // lives as long as this
  int numEliminated() const; // unknowns eliminated; 0 unless the body is condensed

  // Begins, before all that follows: from the deck's initial state, from a state of another run
  // (`state` of stateOfOtherRun), or from a checkpoint.
  void start();
  void startFrom(io::Archive const& state);
  void restore(io::Archive const& checkpoint);
  void save(io::Archive& checkpoint) const;

  // Makes a step. Throws SolveError if even the smallest one fails; the state stays what it was.
  void advance();
  // Adds that step to energy, effort and the count of the floor. Throws SolveError if a value of
  // the state is not finite: the message names field, place, step and time.
  void account();

  bool atEnd() const { return state_.time >= end_; }
  double time() const { return clock_.seconds(state_.time); } // [s]
  double finalTime() const { return clock_.seconds(end_); }   // [s]
  std::int64_t numSteps() const { return control_->memory().num_steps; }
  io::StepInfo stepInfo() const; // of the last step
  // Warns if that step hides a growing slip rate or passes what loads do, or if slip rates ring.
  void watchGrowth();
  // Warns if the slip rate after that step is beyond what the model describes.
  void watchRate();
  // Warns if the body pulls at the fault somewhere; what there was of it in the whole run.
  void watchTension();
  std::optional<Warning> tensionOfRun() const { return tension_watch_.ofRun(); }
  // Warns if a pressure takes all normal stress of the fault somewhere. Collective.
  void watchPressure();
  // Warns if cells do not resolve a front of slip. Collective.
  void watchFront();
  // Throws LostEarthquakes after too many such steps, those before a restart among them.
  void requireLittleGrowth() const { growth_watch_->requireFew(); }
  // What the log should say of steps of the smallest size, or "". Throws SolveError after too many
  // in a row that do not meet the tolerance.
  std::string watchStall();
  // The warnings since the last call, the same on all ranks.
  std::vector<Warning> takeWarnings() { return std::exchange(warnings_, {}); }
  RunSummary summary() const; // without `finished` and `directory`

private:
  std::string placeOf(int vertex) const;
  void requireFinite() const;
  void beginBalance();
  void restoreWatches(io::Archive const& checkpoint);
  void saveWatches(io::Archive& checkpoint) const;

  RCP<const Communicator> communicator_;
  Problem<Dim> problem_;
  std::unique_ptr<dynamics::StaticCondensation> condensation_;
  dynamics::Model const& model_; // the problem, or what it is condensed to
  dynamics::DyadicTime clock_;
  dynamics::DyadicTime::Ticks end_;
  std::unique_ptr<dynamics::CoupledStep> coupled_step_;
  std::unique_ptr<dynamics::StepControl> control_;
  dynamics::EnergyBalance balance_;
  dynamics::State state_;
  dynamics::FaultSample sample_; // of that state, once the balance has advanced to it
  StateFormat format_;
  dynamics::SolveCount count_;
  std::int64_t forced_steps_ = 0;
  FloorCount floor_count_;
  std::vector<Warning> warnings_;
  std::int64_t rises_to_tell_ = 1; // number of increases of J at which the next warning comes
  std::optional<dynamics::GrowthWatch> growth_watch_;
  std::optional<dynamics::SlowSlip> slow_slip_;
  dynamics::RingWatch ring_watch_;
  dynamics::StallWatch stall_watch_;
  double tolerance_;       // of the step control; 0 if it has none
  double rate_before_ = 0; // peak slip rate before the last step [m/s]
  double rate_to_tell_;    // peak slip rate at which the next warning comes [m/s]
  PressureWatch pressure_watch_;
  FrontWatch front_watch_;
  TensionWatch tension_watch_;
  SkippedTimes skipped_times_;
  RunView view_;
};
} // namespace asperity::scenario
