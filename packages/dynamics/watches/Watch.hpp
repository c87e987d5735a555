#pragma once

#include "base/Archive.hpp"
#include "base/Warning.hpp"
#include "dynamics/Body.hpp"
#include "dynamics/State.hpp"
#include "dynamics/checks/FrontZone.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/fault/NormalReaction.hpp"
#include "dynamics/observables/FaultSample.hpp"
#include "parameters/Kind.hpp"

#include <Teuchos_ParameterList.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::dynamics
{
// What a watch looks at: the state at the start of a run or of a restart, or at the end of an
// accepted step.
struct WatchedState
{
  State const& state;
  FaultSample const& sample;     // of that state
  Vector const& force;           // EnergyBalance::force of that state
  std::int64_t energy_increases; // SolveCount::energy_increases so far
  double time;                   // [s]

  struct Step
  {
    double size;        // [s]
    double rate_before; // peak slip rate at its beginning [m/s]
    bool is_forced;     // accepted above the tolerance
    bool is_smallest;   // of the smallest size that the control may choose
    double time_left;   // to the end of the run [s]
  };
  std::optional<Step> step; // none at the start
};

// What watches say: warnings, which log, status and report show, and lines of the log.
struct Notes
{
  std::vector<Warning> warnings;
  std::vector<std::string> lines;

  void add(std::optional<Warning> warning)
  {
    if (warning) {
      warnings.push_back(std::move(*warning));
    }
  }
};

// Looks at each state of a run, warns of results that may be wrong, and ends a run that is of no
// use. All functions do the same on all ranks and may be collective.
class Watch
{
public:
  // The entries that a kind of watch adds to the deck's list `Time Stepping`: none, unless its
  // class has a function of the same name.
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();

  virtual ~Watch() = default;
  virtual void note(WatchedState const& now, Notes& notes) = 0;
  // Throws SolveError if the run has to end. Comes after the notes are written.
  virtual void requireUsefulRun() const {}
  // At the end of the run: a warning about the whole run, and lines of its summary, each with its
  // line break.
  virtual std::optional<Warning> warningOfRun() const { return std::nullopt; }
  virtual std::string report() const { return ""; }

  // What a restart goes on from. A checkpoint of a run without this watch lacks its values.
  virtual void save(Archive&) const {}
  struct Restart
  {
    bool has_smaller_steps = false; // a smaller smallest step than the run before
  };
  virtual void restore(Archive const&, Restart const&) {}
};

// What a watch may know of the model and of the run. Body, fault and deck outlive the watch.
struct WatchContext
{
  Body const& body;
  Fault const& fault;
  ReactionSinceStart const& since_start; // across the fault
  Teuchos::ParameterList const& deck;    // complete
  double tolerance;                      // of the step control; 0 if it has none
  bool adapts;                           // whether step sizes follow from an estimated error

  // Scales of the fault.
  std::optional<FrontZone> const& zone; // behind a front of slip
  std::vector<double> const& weakening; // (num_nodes) L where friction weakens [m], 0 elsewhere
  double slip_distance;                 // the smallest L [m]; 0 if unknown
  double slow_rate;                     // below which slip is slow [m/s]
  double largest_slip_rate;             // that the model describes [m/s]

  std::vector<std::array<double, 3>> const& places_of_loads; // of this rank [m]
};

// Registered under the name of its memory in checkpoints, at the bottom of the file of the watch:
//   ASPERITY_REGISTER(WatchRegistry, "ring_watch", WatchKindOf<RingWatch>)
// A watch is made of the deck's list `Time Stepping`, which has the entries of all kinds, and of a
// WatchContext. Its `meaning` is what it warns of, as "a slip rate that rings".
struct WatchKind : Kind<Watch, WatchContext>
{
  static constexpr char const* registered_as = "watch";
};
template <class Type>
using WatchKindOf = KindOf<WatchKind, Type>;
using WatchRegistry = Registry<WatchKind>;

// All watches that are registered, as one.
class Watches
{
public:
  // parameters: the deck's list `Time Stepping`, complete.
  Watches(Teuchos::ParameterList const& parameters, WatchContext const& context);

  void note(WatchedState const& now, Notes& notes);
  void requireUsefulRun() const;
  std::vector<Warning> warningsOfRun() const;
  std::string report() const;
  void save(Archive& archive) const;
  void restore(Archive const& archive, Watch::Restart const& restart);

private:
  struct Named
  {
    std::string name;
    std::unique_ptr<Watch> watch;
  };
  std::vector<Named> watches_;
};
} // namespace asperity::dynamics
