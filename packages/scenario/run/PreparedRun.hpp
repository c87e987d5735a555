#pragma once

#include "base/Archive.hpp"
#include "io/FieldRegistry.hpp"
#include "io/OutputSet.hpp"
#include "scenario/checks/Description.hpp"
#include "scenario/deck/CommandLine.hpp"
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
// The constructor makes the members in their order, since each needs those before it:
//
//   problem       given: that of the deck, by makeProblem
//   domains       the parts of the mesh that outputs write
//   checkpoints   with the fingerprint of the deck
//   beginning     reads the checkpoint of a restart or the state of another run
//   evolution     clock, step, control; goes on from the beginning
//   unread        reads the deck anew, for entries without effect
//   registry      the fields of the evolution
//   outputs       those of the deck, which take their fields from the registry
template <int Dim>
struct PreparedRun
{
  // `deck` must be complete, with the directions that follow from the mesh (completeDirections).
  // Reads the checkpoint of a restart. Throws InputError if that is of another deck, and SolveError
  // if the state at the start cannot be computed. Collective.
  PreparedRun(RCP<const ParameterList> deck, Problem<Dim> problem, CommandLine const& command_line);
  PreparedRun(PreparedRun const&) = delete; // outputs refer to the evolution
  PreparedRun& operator=(PreparedRun const&) = delete;

  // The first lines of the log. Collective.
  Description description() const;

  RCP<const ParameterList> deck;
  RCP<const Communicator> communicator;
  std::filesystem::path directory; // of the results
  Problem<Dim> problem;
  Domains domains;
  Checkpoints checkpoints;
  Beginning beginning; // its archive is not needed any more once the run has begun
  Evolution<Dim> evolution;
  std::optional<Warning> unread; // entries of the deck
  io::FieldRegistry registry;
  std::unique_ptr<io::OutputSet> outputs;
};
} // namespace asperity::scenario
