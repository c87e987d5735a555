// asperity DECK.xml [options], or asperity --restart DIR [options]. asperity --help lists the
// options, which scenario/deck/CommandLine.cpp declares.
#include "base/Errors.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/Plugins.hpp"
#include "base/program/Signals.hpp"
#include "scenario/DeckParameters.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/DeckRemarks.hpp"
#include "scenario/Registrations.hpp"
#include "scenario/report/Environment.hpp"
#include "scenario/run/RunDeck.hpp"

#include <iostream>

using namespace asperity;
using namespace asperity::scenario;

namespace
{
// Prints on one rank. Returns the status of a program that has nothing else to do.
template <class Print>
int printOnce(Communicator const& communicator, Print const& print)
{
  if (communicator.getRank() == 0) {
    print(std::cout);
  }
  return exit_done;
}

int readAndRun(CommandLine const& line, RCP<const Communicator> const& communicator)
try {
  auto const deck = readCompleteDeck(line);
  if (!line.validate) {
    return runDeck(deck, line, communicator);
  }
  auto const description = validateDeck(deck, line, communicator);
  return printOnce(*communicator, [&](std::ostream& out) {
    print(description, out);
    out << line.deck << " is valid.\n";
  });
} catch (InputError const& error) { // adds numbers of the deck that are probably mistakes
  throw InputError(error.what() + remarkOnLargeValues(line, error.what()));
}

int start(int argc, char** argv, RCP<const Communicator> const& communicator)
{
  // 1. Parse the command line.
  auto line = parseCommandLine(argc, argv);
  if (line.help) {
    return printOnce(*communicator, printHelp);
  }
  if (line.version) {
    return printOnce(*communicator, [&](auto& out) { printEnvironment(*communicator, out); });
  }
  // 2. Load plugins, whose laws and outputs have parameters of a deck, too.
  loadPlugins(line.plugins, registrations);
  if (line.print_parameters) {
    return printOnce(*communicator,
                     [&](auto& out) { printParameters(*deckParameters(), out, line.format); });
  }
  // 3. Read the deck, which a restart finds in the directory of its run, and run it.
  completeRestart(line);
  return readAndRun(line, communicator);
}

#ifdef __ELF__
// Before the constructors of the libraries, which may replace nohup's handlers (Signals.hpp).
using Start = void (*)(int, char**, char**);
[[gnu::section(".preinit_array"), gnu::used]] const Start at_start = noteIgnoredSignals;
#endif
} // namespace

int main(int argc, char** argv)
{
  MpiScope parallel(argc, argv); // starts MPI and Kokkos
  auto const& communicator = parallel.communicator();
  return runGuarded(*communicator, [&] { return start(argc, argv, communicator); });
}
