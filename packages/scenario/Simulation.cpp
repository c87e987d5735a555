#include "scenario/Simulation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/hdf5/File.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/MeetingPoint.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/Signals.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/FaultMotion.hpp"
#include "dynamics/control/NotFinite.hpp"
#include "dynamics/coupling/CoupledStep.hpp"
#include "io/OutputSet.hpp"
#include "io/checkpoint/Archive.hpp"
#include "io/checkpoint/Checkpoint.hpp"
#include "io/files/OutputDirectory.hpp"
#include "io/files/RunLog.hpp"
#include "mesh/PointText.hpp"
#include "scenario/Condensation.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/OutputFields.hpp"
#include "scenario/Problem.hpp"
#include "scenario/RunArchive.hpp"
#include "scenario/RunReport.hpp"
#include "scenario/run/OtherRun.hpp"
#include "scenario/run/StallWatch.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <fstream>
#include <sstream>

namespace asperity::scenario
{
namespace
{
// [s] that ranks wait for each other after a failure.
constexpr double patience = 2;

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
  std::vector<std::string> description() const override { return describe(problem_, *deck_); }

private:
  int makeSteps(StopSignals const& signals);
  void endEarly(std::string const& reason);
  void begin();
  void advance();
  std::string placeOf(int vertex) const;
  void requireFinite() const;
  void watchProgress(io::StepInfo const& info);
  void balanceEnergy();
  void write(io::StepInfo const& info);
  void requireDirectory() const;
  void writeCheckpoint();
  void saveWhatThereIs();
  void report(bool finished);
  io::StepInfo stepInfo() const;
  bool atEnd() const;

  RCP<ParameterList> deck_;
  RCP<const Communicator> communicator_;
  MeetingPoint meeting_point_;
  std::filesystem::path directory_;
  io::DirectoryLock lock_; // of the directory, on rank 0
  std::unique_ptr<io::RunLog> log_;
  Problem<Dim> problem_;
  std::unique_ptr<dynamics::StaticCondensation> condensation_;
  dynamics::Model const& model_; // the problem, or what it is condensed to
  dynamics::DyadicTime clock_;
  dynamics::DyadicTime::Ticks end_;
  std::unique_ptr<dynamics::CoupledStep> coupled_step_;
  std::unique_ptr<dynamics::StepControl> control_;
  dynamics::EnergyBalance balance_;
  dynamics::State state_;
  StateFormat format_;
  dynamics::SolveCount count_;
  std::int64_t forced_steps_ = 0;
  FloorCount floor_count_;
  StallWatch stall_watch_;
  bool step_is_complete_ = false; // energy and outputs know of it
  RunView view_;
  std::map<std::string, io::OutputDomain> domains_;
  io::FieldRegistry registry_;
  std::unique_ptr<io::OutputSet> outputs_;
  std::string restart_, restart_from_;
  io::Fingerprint fingerprint_;
  io::Archive checkpoint_; // of a restart, or the state of another run, until it begins
  int checkpoint_interval_;
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
    , problem_(makeProblem<Dim>(*deck, communicator))
    , condensation_(makeCondensation(problem_, *deck))
    , model_(condensation_ ? condensation_->model() : problem_)
    , clock_(makeClock(deck->sublist("Time Stepping")))
    , end_(clock_.reaching(finalTime(deck->sublist("Time Stepping"))))
    , balance_(model_.body, model_.fault, clock_)
    , state_(model_.initial.clone())
    , format_(problem_.initial, condensation_.get(), clock_)
    , floor_count_(model_.fault)
    , stall_watch_(deck->sublist("Time Stepping").get<int>("Most Forced Steps"))
    , domains_(makeDomains(problem_))
    , restart_(command_line.restart)
    , restart_from_(command_line.restart_from)
    , fingerprint_(fingerprint(*deck, problem_.mesh, *communicator))
    , checkpoint_interval_(deck->sublist("Output").get<int>("Checkpoint Every n Steps"))
{
  auto const update =
    makeRateUpdate(deck->sublist("Time Stepping"), !quasiDynamic(deck->sublist("Bulk")));
  coupled_step_ = std::make_unique<dynamics::CoupledStep>(
    model_.body, model_.fault, update, clock_,
    dynamics::CouplingSettings::from(deck->sublist("Coupling")), problem_.solver,
    memoryBudget(deck->sublist("TNNMG")), model_.reaction);
  control_ = makeStepControl(deck->sublist("Time Stepping"), *coupled_step_);
  control_->setPlaces([this](int vertex) { return placeOf(vertex); });
  view_.state = &state_;
  view_.surface = &model_.fault.surface();
  view_.condensation = condensation_.get();
  view_.clock = &clock_;
  view_.floor_count = &floor_count_;
  view_.balance = &balance_;
  registerFields(registry_, problem_, view_, domains_, deck->sublist("Friction"));
  outputs_ = std::make_unique<io::OutputSet>(
    deck->sublist("Output"), io::OutputContext{directory_, communicator, registry_, domains_});
  if (!restart_from_.empty()) {
    checkpoint_ = stateOfOtherRun(restart_from_, problem_, domains_, *deck, clock_,
                                  finalTime(deck->sublist("Time Stepping")));
  }
  if (command_line.validate) {
    return;
  }
  // A checkpoint of another deck is refused before the first file is touched. Outputs that cannot
  // be continued are refused before the log and the parameters are: other tables may have been cut
  // back to the checkpoint then, as by any restart from it.
  if (!restart_.empty()) {
    checkpoint_ =
      io::readCheckpoint(restart_, fingerprint_, *communicator, nodeSets(problem_, domains_));
  }
  lock_ = io::prepareOutputDirectory(directory_, existingResult(command_line), *communicator);
  if (!restart_.empty()) {
    outputs_->restore(checkpoint_.child("outputs"));
  }
  log_ = std::make_unique<io::RunLog>(directory_ / "run.log", !restart_.empty(), *communicator);
  h5::whenSharingFails([log = directory_ / "run.log"](std::string const& message) {
    std::ofstream(log, std::ios::app) << "The run has ended: " << message << '\n';
  });
  if (communicator->getRank() == 0) {
    writeParameters(*deck, (directory_ / "parameters.xml").string());
  }
}

template <int Dim>
bool SimulationOf<Dim>::atEnd() const
{
  return state_.time >= end_;
}

template <int Dim>
io::StepInfo SimulationOf<Dim>::stepInfo() const
{
  io::StepInfo info;
  info.step = control_->memory().num_steps;
  info.time = clock_.seconds(state_.time);
  info.step_size = info.step > 0 ? clock_.stepSize(view_.step.level) : 0;
  info.peak_slip_rate = dynamics::peakSlipRate(model_.fault.surface(), *state_.v);
  info.is_last = atEnd();
  return info;
}

template <int Dim>
int SimulationOf<Dim>::run()
{
  const StopSignals signals;
  for (auto const& line : description()) {
    log_->message(line);
  }
  if (condensation_) {
    log_->message("The body is in equilibrium at all times: it is condensed to its fault, which "
                  "eliminates " +
                  std::to_string(condensation_->numEliminated()) + " of " +
                  std::to_string(problem_.body.numOwnedDofs()) + " unknowns for all steps.");
  }
  try {
    begin();
    step_is_complete_ = true;
    return makeSteps(signals);
  } catch (OutputError const& error) {
    // What is half written is not written again: the checkpoint before is the last complete state.
    log_->note(std::string("The run has ended: ") + error.what());
    throw;
  } catch (std::exception const& error) {
    endEarly(error.what());
    throw;
  } catch (...) {
    endEarly("an exception of unknown type was thrown.");
    throw;
  }
}

template <int Dim>
int SimulationOf<Dim>::makeSteps(StopSignals const& signals)
{
  while (!atEnd()) {
    advance();
    if (const int signal = signals.agreed(*communicator_)) {
      writeCheckpoint();
      outputs_->finish(); // a restart takes back what is not complete
      report(false);
      log_->message("Stopped by " + signalName(signal) + "; --restart " +
                    (directory_ / "checkpoint.h5").string() + " goes on.");
      return exit_signal;
    }
    if (control_->memory().num_steps % checkpoint_interval_ == 0) {
      writeCheckpoint();
    }
  }
  writeCheckpoint();
  outputs_->finish();
  report(true);
  return exit_done;
}

// A rank that fails alone leaves the others in the middle of something collective, and a checkpoint
// is that, too.
template <int Dim>
void SimulationOf<Dim>::endEarly(std::string const& reason)
{
  if (meeting_point_.meet(patience)) {
    saveWhatThereIs();
  }
  log_->note("The run has ended: " + reason);
}

// What fails here must not hide why the run ends. Where a step has been made but not written, the
// checkpoint before it is the last complete state.
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
    log_->message(std::string("The end of the run could not be saved: ") + error.what());
  }
}

template <int Dim>
void SimulationOf<Dim>::begin()
{
  if (restart_.empty()) {
    if (!restart_from_.empty()) {
      state_ = format_.load(checkpoint_, "state");
      checkpoint_ = {};
      log_->message("A new run from the state of " + restart_from_ +
                    " at t = " + formatShort(clock_.seconds(state_.time)) + " s.");
    }
    balance_.start(state_, {});
    outputs_->write(stepInfo());
    return;
  }
  state_ = format_.load(checkpoint_, "state");
  control_->restore(format_.loadControl(checkpoint_, "control"));
  count_ = loadCount(checkpoint_, "count");
  forced_steps_ = checkpoint_.getInteger("forced_steps");
  floor_count_.restore(checkpoint_, "normal_stress_floor");
  balance_.start(state_, loadEnergy(checkpoint_, "energy"));
  checkpoint_ = {};
  log_->message("Restarted from " + restart_ +
                " at t = " + formatShort(clock_.seconds(state_.time)) + " s.");
}

template <int Dim>
void SimulationOf<Dim>::advance()
{
  auto const before = count_;
  view_.step = control_->advance(state_, count_);
  step_is_complete_ = false;
  view_.count = count_.since(before);
  requireFinite();
  forced_steps_ += view_.step.within_tolerance ? 0 : 1;
  floor_count_.add(state_);
  balanceEnergy();
  auto const info = stepInfo();
  write(info);
  step_is_complete_ = true;

  io::Progress progress;
  progress.time = info.time;
  progress.final_time = clock_.seconds(end_);
  progress.step_size = info.step_size;
  progress.peak_slip_rate = info.peak_slip_rate;
  progress.step = info.step;
  progress.fixed_point_iterations = view_.step.iterations;
  progress.counts = outputs_->counts();
  log_->progress(progress);
  watchProgress(info);
}

template <int Dim>
void SimulationOf<Dim>::watchProgress(io::StepInfo const& info)
{
  const bool is_adaptive =
    deck_->sublist("Time Stepping").get<std::string>("Control") != "Prescribed";
  StallWatch::Step step;
  step.is_smallest =
    is_adaptive && clock_.finestLevel() > 0 && view_.step.level == clock_.finestLevel();
  step.is_forced = !view_.step.within_tolerance;
  step.time = info.time;
  step.step_size = info.step_size;
  step.time_left = clock_.seconds(end_ - state_.time);
  const auto line = stall_watch_.note(step);
  if (!line.empty()) {
    log_->message(line);
  }
}

// Of a vertex of the model: the condensed one has the nodes of the fault, and the boundaries'
// motion.
template <int Dim>
std::string SimulationOf<Dim>::placeOf(int vertex) const
{
  if (condensation_ && vertex >= problem_.surface->numNodes()) {
    return "the boundaries that move";
  }
  vertex = condensation_ ? problem_.surface->vertex(vertex) : vertex;
  return "node " + std::to_string(problem_.mesh.global_ids[vertex]) + ", " +
         mesh::text(problem_.mesh.vertices[vertex]);
}

// The step that has just been made. Where a number is lost, it spreads: the first sight tells most.
template <int Dim>
void SimulationOf<Dim>::requireFinite() const
{
  const auto found = dynamics::firstNotFinite(state_);
  if (maxOverRanks(found ? 1 : 0, *communicator_) == 0) {
    return;
  }
  onEveryRank(*communicator_, [&] {
    if (!found) {
      return;
    }
    const int vertex = found->is_at_fault ? model_.fault.surface().vertex(found->index)
                                          : found->index / model_.body.dofs->components();
    std::ostringstream message;
    message << "Step " << control_->memory().num_steps
            << ", t = " << formatShort(clock_.seconds(state_.time)) << " s: " << found->field
            << " is " << found->value << " at " << placeOf(vertex);
    message << ". Check loads, moduli and friction there. The checkpoint is of an earlier step.";
    throw SolveError(message.str());
  });
}

template <int Dim>
void SimulationOf<Dim>::balanceEnergy()
{
  ASPERITY_TIME_WORK("energy balance");
  balance_.advance(state_);
}

template <int Dim>
void SimulationOf<Dim>::write(io::StepInfo const& info)
{
  ASPERITY_TIME_WORK("output");
  outputs_->write(info);
}

template <int Dim>
void SimulationOf<Dim>::requireDirectory() const
{
  onRoot(*communicator_, [&] {
    if (!std::filesystem::is_directory(directory_)) {
      throw OutputError("The output directory " + directory_.string() +
                        " has been removed while the run was writing to it. What it held is lost: "
                        "begin anew.");
    }
  });
}

template <int Dim>
void SimulationOf<Dim>::writeCheckpoint()
{
  requireDirectory();
  ASPERITY_TIME_WORK("checkpoints");
  outputs_->closeSegment();
  io::Archive archive;
  format_.save(archive, "state", state_);
  format_.save(archive, "control", control_->memory());
  save(archive, "count", count_);
  save(archive, "energy", balance_.energy());
  archive.set("forced_steps", forced_steps_);
  floor_count_.save(archive, "normal_stress_floor");
  archive.insert("outputs", outputs_->save());
  io::writeCheckpoint(directory_ / "checkpoint.h5", archive, fingerprint_, *communicator_,
                      nodeSets(problem_, domains_));
}

template <int Dim>
void SimulationOf<Dim>::report(bool finished)
{
  RunSummary summary;
  summary.finished = finished;
  summary.dimension = Dim;
  summary.time = clock_.seconds(state_.time);
  summary.num_steps = control_->memory().num_steps;
  summary.forced_steps = forced_steps_;
  summary.count = count_;
  summary.of_floor = floor_count_.report();
  summary.energy = balance_.energy();
  summary.setups = coupled_step_->solvers().setups();
  summary.setup_seconds = coupled_step_->solvers().setupSeconds();
  summary.directory = directory_.string();
  log_->message(summarise(summary, outputs_->report()));
  log_->message('\n' + tableOfWork(*communicator_));
}

std::unique_ptr<Simulation> makeSimulation(RCP<ParameterList> const& deck,
                                           CommandLine const& command_line,
                                           RCP<const Communicator> const& communicator)
{
  // Nothing has been computed yet: what cannot be solved here is what the deck asks for.
  try {
    if (meshDimension(deck->sublist("Mesh"), *communicator) == 3) {
      return std::make_unique<SimulationOf<3>>(deck, command_line, communicator);
    }
    return std::make_unique<SimulationOf<2>>(deck, command_line, communicator);
  } catch (SolveError const& error) {
    throw InputError(std::string("The state at the start cannot be computed. ") + error.what() +
                     " Check Boundary Conditions, Bulk and Initial State.");
  }
}
} // namespace asperity::scenario
