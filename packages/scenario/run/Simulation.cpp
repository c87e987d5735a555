#include "scenario/run/Simulation.hpp"

#include "base/Text.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/WorkTimers.hpp"
#include "catalogue/FaultFacts.hpp"
#include "catalogue/stress/CoulombPlanes.hpp"
#include "scenario/report/FaultDescription.hpp"
#include "scenario/report/ReceiverCost.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/SolverSetup.hpp"

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

// Takes the directory; the outputs of a restart go on from the checkpoint.
template <int Dim>
io::DirectoryLock takeDirectory(PreparedRun<Dim>& prepared, CommandLine const& command_line)
{
  auto lock = io::prepareOutputDirectory(prepared.directory, existingResult(command_line),
                                         *prepared.communicator);
  if (!command_line.restart.empty()) {
    prepared.outputs->restore(prepared.beginning.archive.child("outputs"));
  }
  return lock;
}
} // namespace

template <int Dim>
Simulation<Dim>::Simulation(PreparedRun<Dim>& prepared, CommandLine const& command_line)
    : prepared_(prepared)
    , evolution_(prepared.evolution)
    , outputs_(*prepared.outputs)
    , meeting_point_(*prepared.communicator)
    , restart_(command_line.restart)
    , restart_from_(command_line.restart_from)
    , of_start_(prepared.description())
    , lock_(takeDirectory(prepared, command_line))
    , record_(prepared.directory, !restart_.empty(), *prepared.communicator)
{
  if (prepared.communicator->getRank() == 0) {
    writeParameters(*prepared.deck, (prepared.directory / "parameters.xml").string());
  }
}

template <int Dim>
int Simulation<Dim>::run()
{
  const StopSignals signals;
  describeStart();
  try {
    begin();
    step_is_complete_ = true;
    return makeSteps(signals);
  } catch (OutputError const& error) {
    // No checkpoint is written here: the files of the run are incomplete, and the last checkpoint
    // belongs to the last complete state.
    record_.fail(error);
    throw;
  } catch (std::exception const& error) {
    recordFailure(error);
    throw;
  } catch (...) {
    recordFailure(std::runtime_error("an exception of unknown type was thrown."));
    throw;
  }
}

template <int Dim>
void Simulation<Dim>::describeStart()
{
  for (auto const& line : of_start_.lines) {
    record_.message(line);
  }
  for (auto const& warning : of_start_.warnings) {
    record_.warn(warning);
  }
  recordFault();
  for (auto const& [name, domain] : outputs_.leftOut()) {
    record_.message("Output / " + name + " is left out: the model has no " + domain +
                    (domain == "surface" ? ". Give a boundary the Type Free Surface." : "."));
  }
  for (auto const& plane :
       catalogue::unwrittenPlanes(prepared_.deck->sublist(deck_lists::output))) {
    record_.message("Output / Coulomb Planes / " + plane + " is not written: no Fields name " +
                    catalogue::coulombField(plane) + '.');
  }
  if (const int eliminated = evolution_.numEliminated()) {
    record_.message("The body is in equilibrium at all times. It is condensed to its fault, which "
                    "eliminates " +
                    std::to_string(eliminated) + " of " +
                    std::to_string(evolution_.problem().model.body.numOwnedDofs()) +
                    " unknowns once for all steps.");
  } else if (const auto hint = hintOnDirect(evolution_.problem().settings.solver, Dim,
                                            evolution_.problem().mesh().num_global_vertices *
                                              evolution_.problem().components());
             !hint.empty()) {
    record_.message(hint);
  }
}

template <int Dim>
void Simulation<Dim>::recordFault()
{
  auto const fault = prepared_.domains.find("fault");
  if (fault != prepared_.domains.end()) {
    auto facts =
      catalogue::faultFacts(fault->second, evolution_.problem().discretisation.upright.up);
    facts["one_sense"] = {haveOneSense(evolution_.problem()) ? 1. : 0.};
    record_.fault(facts);
  }
}

template <int Dim>
int Simulation<Dim>::makeSteps(StopSignals const& signals)
{
  while (!evolution_.atEnd() && !outputs_.endsRun()) {
    advance();
    auto const agreed = signals.agreed(prepared_.checkpoints.isTime(), *prepared_.communicator);
    if (agreed.signal != 0) {
      writeCheckpoint();
      outputs_.finish(); // a restart takes back what is not complete
      report(false);
      record_.end("stopped", exit_signal);
      record_.message("Stopped by " + signalName(agreed.signal) + "; --restart " +
                      prepared_.checkpoints.file().string() + " goes on.");
      return exit_signal;
    }
    if (agreed.wished || prepared_.checkpoints.areDueAfter(evolution_.numSteps())) {
      writeCheckpoint();
    }
  }
  if (!evolution_.atEnd()) {
    record_.message("The run ends before its final time: it has as many events as "
                    "'Event Catalogue / Most Events' allows.");
  }
  writeCheckpoint();
  outputs_.finish();
  report(true);
  record_.end("finished", exit_done);
  return exit_done;
}

template <int Dim>
void Simulation<Dim>::watch()
{
  evolution_.watch();
  record_.at(evolution_.numSteps(), evolution_.time());
  auto const notes = evolution_.takeNotes();
  for (auto const& warning : notes.warnings) {
    record_.warn(warning);
  }
  for (auto const& line : notes.lines) {
    record_.message(line);
  }
  evolution_.watches().requireUsefulRun();
}

// If a single rank fails, the others wait in a collective operation. A checkpoint is collective,
// too, and is written only if all ranks come here.
template <int Dim>
void Simulation<Dim>::recordFailure(std::exception const& error)
{
  if (meeting_point_.meet(timeout)) {
    saveCompleteSteps();
  }
  record_.fail(error);
}

// An error in here must not hide the reason why the run ends. If a step has been made but not
// written, the last checkpoint stays: it has the last complete state.
template <int Dim>
void Simulation<Dim>::saveCompleteSteps()
{
  try {
    if (step_is_complete_) {
      writeCheckpoint();
    }
    outputs_.finish();
    report(false);
  } catch (std::exception const& error) {
    record_.message(std::string("The end of the run could not be saved: ") + error.what());
  }
}

template <int Dim>
void Simulation<Dim>::begin()
{
  const auto at = [this] { return " at t = " + formatShort(evolution_.time()) + " s."; };
  auto& start = prepared_.beginning.archive;
  if (!restart_.empty()) {
    record_.at(evolution_.numSteps(), evolution_.time());
    record_.restore(start);
    record_.message("Restarted from " + restart_ + at());
  } else {
    if (!restart_from_.empty()) {
      record_.message("A new run from the state of " + restart_from_ + at());
      record_.inherit(start);
    }
    outputs_.write(evolution_.stepInfo());
  }
  watch();
  if (evolution_.time() > evolution_.finalTime()) {
    record_.warn({"final time", "The results go on beyond 'Time Stepping / Final Time' = " +
                                  formatShort(evolution_.finalTime()) + " s: the state of " +
                                  restart_ + " is that" + at() +
                                  " Begin a new run if it is to end before."});
  }
  if (evolution_.atEnd()) {
    record_.message("The final time, " + formatShort(evolution_.finalTime()) +
                    " s, has passed: there is nothing to do. Give a later 'Time Stepping / "
                    "Final Time' to go on.");
  }
  if (auto const& rows = evolution_.view().recovery_rows) {
    if (auto const text = describeReceiverCost(rows->cost()); !text.empty()) {
      record_.message(text);
    }
  }
  start = {};
}

template <int Dim>
void Simulation<Dim>::advance()
{
  evolution_.advance();
  step_is_complete_ = false;
  evolution_.updateTotals();
  auto info = evolution_.stepInfo();
  info.wall_time = record_.wallTime();
  write(info);
  step_is_complete_ = true;
  watch();
  recordProgress(info);
}

template <int Dim>
void Simulation<Dim>::recordProgress(io::StepInfo const& info)
{
  io::Progress progress;
  progress.time = info.time;
  progress.final_time = evolution_.finalTime();
  progress.step_size = info.step_size;
  progress.peak_slip_rate = info.peak_slip_rate;
  progress.step = info.step;
  progress.fixed_point_iterations = evolution_.view().step.iterations;
  progress.num_events = outputs_.numEvents();
  progress.wall_time = info.wall_time;
  record_.progress(progress);
}

template <int Dim>
void Simulation<Dim>::write(io::StepInfo const& info)
{
  ASPERITY_TIME_WORK("output");
  outputs_.write(info);
}

template <int Dim>
void Simulation<Dim>::writeCheckpoint()
{
  const auto save = [this](Archive& archive) {
    outputs_.closeSegment();
    evolution_.save(archive);
    archive.insert("outputs", outputs_.save());
    record_.save(archive);
  };
  prepared_.checkpoints.write(save, nodeSets(evolution_.problem(), prepared_.domains));
}

template <int Dim>
void Simulation<Dim>::report(bool finished)
{
  RunSummary summary = evolution_.summary();
  summary.finished = finished;
  summary.directory = prepared_.directory.string();
  record_.message(summarise(summary, outputs_.report()));
  auto warnings = evolution_.watches().warningsOfRun();
  if (auto const warning = warnOfDefect(summary.energy)) {
    warnings.push_back(*warning);
  }
  for (auto const& warning : warnings) {
    record_.warn(warning);
  }
  if (auto const topics = record_.topics(); !topics.empty()) {
    record_.message(
      "\nThe results may be wrong. There are warnings, above and in asperity-status, about " +
      quotedNames({topics.begin(), topics.end()}) + ".");
  }
  record_.message('\n' + tableOfWork(*prepared_.communicator));
}

template class Simulation<2>;
template class Simulation<3>;
} // namespace asperity::scenario
