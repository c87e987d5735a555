#pragma once

#include "base/Warning.hpp"
#include "dynamics/coupling/CoupledStep.hpp"
#include "dynamics/watches/Watch.hpp"
#include "io/Output.hpp"
#include "scenario/fields/FloorCount.hpp"
#include "scenario/fields/RunView.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/report/RunSummary.hpp"
#include "scenario/run/Condensation.hpp"
#include "scenario/run/WholeBodyArchive.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::scenario
{
// From which state time stepping begins.
struct Beginning
{
  enum class From
  {
    deck,
    other_run,  // archive: of stateOfOtherRun
    checkpoint, // archive: of Checkpoints::read
  };
  From from = From::deck;
  Archive archive = {};
};

// The clock of the deck's time stepping.
template <int Dim>
dynamics::DyadicTime clockOf(Problem<Dim> const& problem);

// The time stepping of a problem: its state, its steps, and the sums of energy, effort and nodes on
// the floor of the normal stress.
template <int Dim>
class Evolution
{
public:
  // The problem is that of the deck, and both must outlive this. The deck is for watches alone,
  // which may look at all of it. Collective, as all that follows.
  Evolution(Problem<Dim> const& problem, ParameterList const& deck, Beginning const& beginning);
  Evolution(Evolution const&) = delete; // the view refers to members
  Evolution& operator=(Evolution const&) = delete;

  Problem<Dim> const& problem() const { return problem_; }
  dynamics::DyadicTime const& clock() const { return clock_; }
  RunView const& view() const { return view_; } // lives as long as this
  int numEliminated() const; // unknowns eliminated; 0 unless the body is condensed

  void save(Archive& checkpoint) const;

  // Makes a step. Throws SolveError if even the smallest one fails; the state stays what it was.
  void advance();
  // Adds that step to energy, effort and the count of the floor. Throws SolveError if a value of
  // the state is not finite: the message names field, place, step and time.
  void updateTotals();

  bool atEnd() const { return state_.time >= end_; }
  double time() const { return clock_.seconds(state_.time); } // [s]
  double finalTime() const { return clock_.seconds(end_); }   // [s]
  std::int64_t numSteps() const { return control_->memory().num_steps; }
  io::StepInfo stepInfo() const; // of the last step
  // Lets all watches look at the present state, after a step or at the start.
  void watch();
  dynamics::Watches const& watches() const { return watches_; }
  // What they have noted since the last call, and warnings of the start.
  dynamics::Notes takeNotes() { return std::exchange(notes_, {}); }
  RunSummary summary() const; // without `finished` and `directory`

private:
  void restore(Archive const& checkpoint);
  std::string placeOf(int vertex) const;
  void requireFinite() const;
  void beginBalance();
  dynamics::Watches makeWatches(ParameterList const& deck) const;

  RCP<const Communicator> communicator_;
  Problem<Dim> const& problem_;
  std::unique_ptr<dynamics::StaticCondensation> condensation_;
  dynamics::Model const& model_; // the problem, or what it is condensed to
  dynamics::DyadicTime clock_;
  dynamics::DyadicTime::Ticks end_;
  std::unique_ptr<dynamics::CoupledStep> coupled_step_;
  std::unique_ptr<dynamics::StepControl> control_;
  dynamics::EnergyBalance balance_;
  dynamics::State state_;
  dynamics::FaultSample sample_; // of that state, once the balance has advanced to it
  dynamics::SolveCount count_;
  std::int64_t forced_steps_ = 0;
  FloorCount floor_count_;
  double rate_before_ = 0;   // peak slip rate before the last step [m/s]
  bool has_stepped_ = false; // since the start or restart
  dynamics::Notes notes_;
  dynamics::Watches watches_;
  RunView view_;
};
} // namespace asperity::scenario
