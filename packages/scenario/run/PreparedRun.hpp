#pragma once

#include "base/Archive.hpp"
#include "io/FieldRegistry.hpp"
#include "io/OutputSet.hpp"
#include "scenario/deck/CommandLine.hpp"
#include "scenario/report/Description.hpp"
#include "scenario/run/Checkpoints.hpp"
#include "scenario/run/Evolution.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace asperity::scenario
{
// A run before it touches a file: the problem with its steps, and the outputs that read from it.
//
// The constructor does all of this in the order of the members, since each needs those before it:
//
//   problem       makeProblem: mesh, matrices, static solution, fault, state at the start
//   domains       the parts of the mesh that outputs write
//   checkpoints   the deck gets the directions that follow from the mesh; its fingerprint
//   beginning     reads the checkpoint of a restart or the state of another run
//   evolution     clock, step, control; goes on from the beginning
//   unread        reads the deck anew, for entries without effect
//   outputs       with the fields of the evolution
template <int Dim>
struct PreparedRun
{
  // `deck` must be complete; entries that follow from the mesh are set in it. Throws SolveError if
  // the state at the start cannot be computed. Reads the checkpoint of a restart, and refuses that
  // of another deck. Collective.
  PreparedRun(RCP<ParameterList> const& deck, CommandLine const& command_line,
              RCP<const Communicator> const& communicator);
  PreparedRun(PreparedRun const&) = delete; // outputs refer to the evolution
  PreparedRun& operator=(PreparedRun const&) = delete;

  // The first lines of the log. Collective.
  Description description() const;

  RCP<ParameterList> deck;
  RCP<const Communicator> communicator;
  std::filesystem::path directory; // of the results
  Problem<Dim> problem;
  Domains domains;
  Checkpoints checkpoints;
  Beginning beginning; // its archive is not needed any more once the run has begun
  Evolution<Dim> evolution;
  io::FieldRegistry registry;
  std::unique_ptr<io::OutputSet> outputs;
  std::optional<Warning> unread; // entries of the deck
};
} // namespace asperity::scenario
