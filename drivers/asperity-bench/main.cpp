// asperity-bench COMMAND DECK.xml [options]. The commands are in BenchArguments.cpp.
#include "BenchArguments.hpp"

#include "base/Errors.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/Plugins.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Registrations.hpp"

#include <fstream>
#include <iostream>

namespace
{
void write(std::string const& file_name, std::string const& text)
{
  std::ofstream file(file_name);
  file << text;
  file.close();
  ASPERITY_REQUIRE(file.good(), "Cannot write '" << file_name << "'.");
}
} // namespace

int main(int argc, char** argv)
{
  // 1. Start MPI and Kokkos.
  asperity::MpiScope parallel(argc, argv);
  auto const& communicator = parallel.communicator();
  return asperity::runGuarded(
    *communicator,
    [&] {
      // 2. Read the command line.
      auto const arguments = asperity::bench::parseBenchArguments(argc, argv);
      const bool is_root = communicator->getRank() == 0;
      if (arguments.help) {
        if (is_root) {
          asperity::bench::printBenchHelp(std::cout);
        }
        return int(asperity::exit_done);
      }
      asperity::loadPlugins(arguments.deck.plugins, asperity::scenario::registrations);
      // 3. Read the deck and measure.
      auto const deck = asperity::scenario::readCompleteDeck(arguments.deck);
      auto const report = arguments.command->measure(*deck, arguments, communicator);
      // 4. Print the table and write the file.
      if (is_root) {
        std::cout << report.table << std::flush;
        if (!arguments.output.empty()) {
          write(arguments.output, report.file);
        }
      }
      return int(asperity::exit_done);
    },
    "asperity-bench");
}
