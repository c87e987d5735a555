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

namespace
{
int runDeck(asperity::CommandLine const& command_line,
            asperity::RCP<const asperity::Communicator> const& communicator)
try {
  // 3. Read the deck.
  auto const deck = asperity::scenario::readCompleteDeck(command_line);
  if (command_line.validate) {
    auto const description = asperity::scenario::validateDeck(deck, command_line, communicator);
    if (communicator->getRank() == 0) {
      asperity::scenario::print(description, std::cout);
      std::cout << command_line.deck << " is valid.\n";
    }
    return asperity::exit_done;
  }
  // 4. Run it; it prints its own report.
  return asperity::scenario::runDeck(deck, command_line, communicator);
} catch (asperity::InputError const& error) { // adds numbers of the deck that are probably mistakes
  throw asperity::InputError(error.what() +
                             asperity::scenario::remarkOnLargeValues(command_line, error.what()));
}

#ifdef __ELF__
// Before the constructors of the libraries, which may replace nohup's handlers (Signals.hpp).
using Start = void (*)(int, char**, char**);
[[gnu::section(".preinit_array"), gnu::used]] const Start at_start = asperity::noteIgnoredSignals;
#endif
} // namespace

int main(int argc, char** argv)
{
  // 1. Start MPI and Kokkos.
  asperity::MpiScope parallel(argc, argv);
  auto const& communicator = parallel.communicator();
  return asperity::runGuarded(*communicator, [&] {
    // 2. Read the command line.
    auto command_line = asperity::parseCommandLine(argc, argv);
    const bool is_root = communicator->getRank() == 0;
    if (command_line.help) {
      if (is_root) {
        asperity::printHelp(std::cout);
      }
      return int(asperity::exit_done);
    }
    if (command_line.version) {
      if (is_root) {
        asperity::scenario::printEnvironment(*communicator, std::cout);
      }
      return int(asperity::exit_done);
    }
    asperity::loadPlugins(command_line.plugins, asperity::scenario::registrations);
    if (command_line.print_parameters) {
      if (is_root) {
        asperity::printParameters(*asperity::scenario::deckParameters(), std::cout,
                                  command_line.format);
      }
      return int(asperity::exit_done);
    }
    asperity::completeRestart(command_line);
    return runDeck(command_line, communicator);
  });
}
