#include "scenario/run/Simulation.hpp"

#include "base/Archive.hpp"
#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/MeetingPoint.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/Signals.hpp"
#include "base/program/WorkTimers.hpp"
#include "catalogue/FaultFacts.hpp"
#include "catalogue/receivers/OnFault.hpp"
#include "catalogue/stress/CoulombPlanes.hpp"
#include "io/OutputSet.hpp"
#include "io/files/OutputDirectory.hpp"
#include "io/files/RunRecord.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/LockedFields.hpp"
#include "scenario/OutputFields.hpp"
#include "scenario/deck/Coordinates.hpp"
#include "scenario/report/FaultSense.hpp"
#include "scenario/report/RunReport.hpp"
#include "scenario/run/Checkpoints.hpp"
#include "scenario/run/Evolution.hpp"
#include "scenario/run/OtherRun.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"

namespace asperity::scenario
{
namespace
{
// [s] that ranks wait for each other after a failure.
constexpr double timeout = 2;

io::ExistingResult existingResult(CommandLine const& command_line)
{
  if (!command_line.restart.empty()) {
    return io::ExistingResult::keep;
  }
  return command_line.overwrite ? io::ExistingResult::overwrite : io::ExistingResult::refuse;
}

template <int Dim>
class SimulationOf final : public Simulation
{
public:
  SimulationOf(RCP<ParameterList> const& deck, CommandLine const& command_line,
               RCP<const Communicator> const& communicator);

  int run() override;
  Description description() const override;

private:
  void tellOfFault(); // to the journal
  int makeSteps(StopSignals const& signals);
  void begin();
  void advance();
  void write(io::StepInfo const& info);
  void tellProgress(io::StepInfo const& info);
  void writeCheckpoint();
  void watch();
  void endEarly(std::exception const& error);
  void saveWhatThereIs();
  void report(bool finished);

  RCP<ParameterList> deck_;
  RCP<const Communicator> communicator_;
  MeetingPoint meeting_point_;
  std::filesystem::path directory_;
  io::DirectoryLock lock_; // of the directory, on rank 0
  std::unique_ptr<io::RunRecord> record_;
  Evolution<Dim> evolution_;
  bool step_is_complete_ = false; // counted in the energy balance and written to the outputs
  std::map<std::string, io::OutputDomain> domains_;
  io::FieldRegistry registry_;
  std::unique_ptr<io::OutputSet> outputs_;
  std::optional<Warning> unread_; // entries of the deck
  std::string restart_, restart_from_;
  Archive start_; // of a restart, or the state of another run, until it begins
  Checkpoints checkpoints_;
};
} // namespace

std::filesystem::path outputDirectory(CommandLine const& command_line)
{
  if (!command_line.output.empty()) {
    return command_line.output;
  }
  return std::filesystem::path("results") / std::filesystem::path(command_line.deck).stem();
}

template <int Dim>
SimulationOf<Dim>::SimulationOf(RCP<ParameterList> const& deck, CommandLine const& command_line,
                                RCP<const Communicator> const& communicator)
    : deck_(deck)
    , communicator_(communicator)
    , meeting_point_(*communicator)
    , directory_(outputDirectory(command_line))
    , evolution_(*deck, communicator)
    , domains_(makeDomains(evolution_.problem()))
    , unread_(warnOfUnreadEntries(command_line, *deck))
    , restart_(command_line.restart)
    , restart_from_(command_line.restart_from)
    , checkpoints_(directory_, deck->sublist("Output"), command_line.plugins,
                   fingerprint(completeDirections(*deck, Dim, evolution_.problem().upright),
                               evolution_.problem().mesh, *communicator),
                   communicator)
{
  registerFields(registry_, evolution_.problem(), evolution_.view(), domains_,
                 deck->sublist("Friction"));
  registerLockedResponse(registry_, evolution_.problem(), evolution_.view(), domains_);
  registerStress(registry_, evolution_.problem(), evolution_.view(), domains_,
                 deck->sublist("Output"));
  outputs_ = std::make_unique<io::OutputSet>(
    deck->sublist("Output"),
    io::OutputContext{
      directory_, communicator, registry_, domains_, {0, 1, 0}, evolution_.finalTime()});
  if (!restart_from_.empty()) {
    start_ = stateOfOtherRun(restart_from_, evolution_.problem(), domains_, *deck,
                             evolution_.clock(), finalTime(deck->sublist("Time Stepping")));
  }
  if (command_line.validate) {
    return;
  }
  // A checkpoint of another deck is refused before any file is touched. Outputs that cannot be
  // continued are refused before the log and the parameters are touched; other tables may have been
  // cut back to the checkpoint by then, as any restart does.
  if (!restart_.empty()) {
    start_ = checkpoints_.read(restart_, nodeSets(evolution_.problem(), domains_));
  }
  lock_ = io::prepareOutputDirectory(directory_, existingResult(command_line), *communicator);
  if (!restart_.empty()) {
    outputs_->restore(start_.child("outputs"));
  }
  record_ = std::make_unique<io::RunRecord>(directory_, !restart_.empty(), *communicator);
  if (communicator->getRank() == 0) {
    writeParameters(*deck, (directory_ / "parameters.xml").string());
  }
}

template <int Dim>
Description SimulationOf<Dim>::description() const
{
  auto result = describe(evolution_.problem(), *deck_);
  if (unread_) {
    result.warnings.push_back(*unread_);
  }
  auto const fault = domains_.find("fault");
  if (fault == domains_.end()) {
    return result;
  }
  if (auto const warning = catalogue::warnOfReceiversOnFault(
        deck_->sublist("Output").sublist("Receivers"), domains_.at("volume"), fault->second,
        evolution_.problem().mesh.splits)) {
    result.warnings.push_back(*warning);
  }
  return result;
}

template <int Dim>
int SimulationOf<Dim>::run()
{
  const StopSignals signals;
  auto const of_start = description();
  for (auto const& line : of_start.lines) {
    record_->message(line);
  }
  for (auto const& warning : of_start.warnings) {
    record_->warn(warning);
  }
  tellOfFault();
  for (auto const& [name, domain] : outputs_->leftOut()) {
    record_->message("Output / " + name + " is left out: the model has no " + domain +
                     (domain == "surface" ? ". Give a boundary the Type Free Surface." : "."));
  }
  for (auto const& plane : catalogue::unwrittenPlanes(deck_->sublist("Output"))) {
    record_->message("Output / Coulomb Planes / " + plane + " is not written: no Fields name " +
                     catalogue::coulombField(plane) + '.');
  }
  if (const int eliminated = evolution_.numEliminated()) {
    record_->message("The body is in equilibrium at all times. It is condensed to its fault, which "
                     "eliminates " +
                     std::to_string(eliminated) + " of " +
                     std::to_string(evolution_.problem().body.numOwnedDofs()) +
                     " unknowns once for all steps.");
  } else if (const auto hint = hintOnDirect(deck_->sublist("TNNMG"), Dim,
                                            evolution_.problem().mesh.num_global_vertices *
                                              evolution_.problem().components);
             !hint.empty()) {
    record_->message(hint);
  }
  try {
    begin();
    step_is_complete_ = true;
    return makeSteps(signals);
  } catch (OutputError const& error) {
    // No checkpoint is written here: the files of the run are incomplete, and the last checkpoint
    // belongs to the last complete state.
    record_->fail(error);
    throw;
  } catch (std::exception const& error) {
    endEarly(error);
    throw;
  } catch (...) {
    endEarly(std::runtime_error("an exception of unknown type was thrown."));
    throw;
  }
}

template <int Dim>
void SimulationOf<Dim>::tellOfFault()
{
  auto const fault = domains_.find("fault");
  if (fault != domains_.end()) {
    auto facts = catalogue::faultFacts(fault->second, evolution_.problem().upright.up);
    facts["one_sense"] = {haveOneSense(evolution_.problem(), *deck_) ? 1. : 0.};
    record_->fault(facts);
  }
}

template <int Dim>
int SimulationOf<Dim>::makeSteps(StopSignals const& signals)
{
  while (!evolution_.atEnd() && !outputs_->endsRun()) {
    advance();
    auto const agreed = signals.agreed(checkpoints_.isTime(), *communicator_);
    if (agreed.signal != 0) {
      writeCheckpoint();
      outputs_->finish(); // a restart takes back what is not complete
      report(false);
      record_->end("stopped", exit_signal);
      record_->message("Stopped by " + signalName(agreed.signal) + "; --restart " +
                       checkpoints_.file().string() + " goes on.");
      return exit_signal;
    }
    if (agreed.wished || checkpoints_.areDueAfter(evolution_.numSteps())) {
      writeCheckpoint();
    }
  }
  if (!evolution_.atEnd()) {
    record_->message("The run ends before its final time: it has as many events as "
                     "'Event Catalogue / Most Events' allows.");
  }
  writeCheckpoint();
  outputs_->finish();
  report(true);
  record_->end("finished", exit_done);
  return exit_done;
}

template <int Dim>
void SimulationOf<Dim>::watch()
{
  evolution_.watch();
  record_->at(evolution_.numSteps(), evolution_.time());
  auto const notes = evolution_.takeNotes();
  for (auto const& warning : notes.warnings) {
    record_->warn(warning);
  }
  for (auto const& line : notes.lines) {
    record_->message(line);
  }
  evolution_.watches().requireUse();
}

// If a single rank fails, the others wait in a collective operation. A checkpoint is collective,
// too, and is written only if all ranks come here.
template <int Dim>
void SimulationOf<Dim>::endEarly(std::exception const& error)
{
  if (meeting_point_.meet(timeout)) {
    saveWhatThereIs();
  }
  record_->fail(error);
}

// An error in here must not hide the reason why the run ends. If a step has been made but not
// written, the last checkpoint stays: it has the last complete state.
template <int Dim>
void SimulationOf<Dim>::saveWhatThereIs()
{
  try {
    if (step_is_complete_) {
      writeCheckpoint();
    }
    outputs_->finish();
    report(false);
  } catch (std::exception const& error) {
    record_->message(std::string("The end of the run could not be saved: ") + error.what());
  }
}

template <int Dim>
void SimulationOf<Dim>::begin()
{
  const auto at = [this] { return " at t = " + formatShort(evolution_.time()) + " s."; };
  if (!restart_.empty()) {
    evolution_.restore(start_);
    record_->at(evolution_.numSteps(), evolution_.time());
    record_->restore(start_);
    record_->message("Restarted from " + restart_ + at());
  } else {
    if (!restart_from_.empty()) {
      evolution_.startFrom(start_);
      record_->message("A new run from the state of " + restart_from_ + at());
      record_->inherit(start_);
    } else {
      evolution_.start();
    }
    outputs_->write(evolution_.stepInfo());
  }
  watch();
  if (evolution_.time() > evolution_.finalTime()) {
    record_->warn({"final time", "The results go on beyond 'Time Stepping / Final Time' = " +
                                   formatShort(evolution_.finalTime()) + " s: the state of " +
                                   restart_ + " is that" + at() +
                                   " Begin a new run if it is to end before."});
  }
  if (evolution_.atEnd()) {
    record_->message("The final time, " + formatShort(evolution_.finalTime()) +
                     " s, has passed: there is nothing to do. Give a later 'Time Stepping / "
                     "Final Time' to go on.");
  }
  if (auto const& rows = evolution_.view().recovery_rows; rows && !rows->report().empty()) {
    record_->message(rows->report());
  }
  start_ = {};
}

template <int Dim>
void SimulationOf<Dim>::advance()
{
  evolution_.advance();
  step_is_complete_ = false;
  evolution_.account();
  auto info = evolution_.stepInfo();
  info.wall_time = record_->wallTime();
  write(info);
  step_is_complete_ = true;
  watch();
  tellProgress(info);
}

template <int Dim>
void SimulationOf<Dim>::tellProgress(io::StepInfo const& info)
{
  io::Progress progress;
  progress.time = info.time;
  progress.final_time = evolution_.finalTime();
  progress.step_size = info.step_size;
  progress.peak_slip_rate = info.peak_slip_rate;
  progress.step = info.step;
  progress.fixed_point_iterations = evolution_.view().step.iterations;
  progress.num_events = outputs_->numEvents();
  progress.wall_time = info.wall_time;
  record_->progress(progress);
}

template <int Dim>
void SimulationOf<Dim>::write(io::StepInfo const& info)
{
  ASPERITY_TIME_WORK("output");
  outputs_->write(info);
}

template <int Dim>
void SimulationOf<Dim>::writeCheckpoint()
{
  const auto save = [this](Archive& archive) {
    outputs_->closeSegment();
    evolution_.save(archive);
    archive.insert("outputs", outputs_->save());
    record_->save(archive);
  };
  checkpoints_.write(save, nodeSets(evolution_.problem(), domains_));
}

template <int Dim>
void SimulationOf<Dim>::report(bool finished)
{
  RunSummary summary = evolution_.summary();
  summary.finished = finished;
  summary.directory = directory_.string();
  record_->message(summarise(summary, outputs_->report()));
  auto warnings = evolution_.watches().warningsOfRun();
  if (auto const warning = warnOfDefect(summary.energy)) {
    warnings.push_back(*warning);
  }
  for (auto const& warning : warnings) {
    record_->warn(warning);
  }
  if (auto const topics = record_->topics(); !topics.empty()) {
    record_->message(
      "\nThe results may be wrong. There are warnings, above and in asperity-status, about " +
      quotedNames({topics.begin(), topics.end()}) + ".");
  }
  record_->message('\n' + tableOfWork(*communicator_));
}

std::unique_ptr<Simulation> makeSimulation(RCP<ParameterList> const& deck,
                                           CommandLine const& command_line,
                                           RCP<const Communicator> const& communicator)
{
  // A problem that cannot be solved before the first step is an error of the deck.
  try {
    if (meshDimension(deck->sublist("Mesh"), *communicator) == 3) {
      return std::make_unique<SimulationOf<3>>(deck, command_line, communicator);
    }
    refuseZ(*deck);
    return std::make_unique<SimulationOf<2>>(deck, command_line, communicator);
  } catch (SolveError const& error) {
    throw InputError(std::string("The state at the start cannot be computed. ") + error.what() +
                     " Check Boundary Conditions, Bulk and Initial State.");
  }
}
} // namespace asperity::scenario
