// asperity-bench scaling DECK.xml --sizes H,H,... --steps TAU,TAU,... [--size-parameter PATH]
// [--rupture-rate V] [--set "Path/To/Parameter=value"]... [--output FILE.json]
// asperity-bench mesh DECK.xml [--set "Path/To/Parameter=value"]...
#include "BenchArguments.hpp"
#include "MeshCounts.hpp"
#include "Scaling.hpp"
#include "base/Errors.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/Plugins.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Registrations.hpp"

#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
int countMesh(BenchArguments const& arguments,
              asperity::RCP<const asperity::Communicator> const& communicator)
{
  auto const deck = asperity::scenario::readCompleteDeck(arguments.deck);
  auto const text = meshCounts(*deck, communicator);
  if (communicator->getRank() == 0) {
    std::cout << text << std::flush;
  }
  return asperity::exit_done;
}

int scaling(BenchArguments const& arguments,
            asperity::RCP<const asperity::Communicator> const& communicator)
{
  // 3. Measure one mesh after the other, from coarse to fine.
  const bool speaks = communicator->getRank() == 0;
  std::vector<MeshSample> samples;
  for (double size : arguments.scaling.sizes) {
    auto command_line = arguments.deck;
    std::ostringstream assignment;
    assignment << arguments.scaling.cell_size << '=' << size;
    command_line.overrides.push_back(assignment.str());
    auto const deck = asperity::scenario::readCompleteDeck(command_line);
    samples.push_back(measureMesh(*deck, arguments.scaling, size, communicator));
    if (speaks) {
      std::cout << scalingTable({samples.back()}, communicator->getSize()) << std::flush;
    }
  }
  // 4. Write the same numbers as JSON.
  if (speaks && !arguments.output.empty()) {
    std::ofstream file(arguments.output);
    file << scalingJson(samples, communicator->getSize());
    file.close();
    ASPERITY_REQUIRE(file.good(), "Cannot write '" << arguments.output << "'.");
  }
  return asperity::exit_done;
}
} // namespace

int main(int argc, char** argv)
{
  // 1. Start MPI and Kokkos.
  asperity::MpiScope parallel(argc, argv);
  auto const communicator = parallel.communicator();
  return asperity::runGuarded(
    *communicator,
    [&] {
      // 2. Read the command line.
      auto const arguments = parseBenchArguments(argc, argv);
      if (arguments.help) {
        if (communicator->getRank() == 0) {
          printBenchHelp(std::cout);
        }
        return int(asperity::exit_done);
      }
      asperity::loadPlugins(arguments.deck.plugins, asperity::scenario::registrations);
      return arguments.counts_mesh ? countMesh(arguments, communicator)
                                   : scaling(arguments, communicator);
    },
    "asperity-bench");
}
