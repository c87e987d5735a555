// asperity-bench scaling DECK.xml --sizes H,H,... --steps TAU,TAU,... [--size-parameter PATH]
// [--rupture-rate V] [--set "Path/To/Parameter=value"]... [--output FILE.json]
// asperity-bench steps DECK.xml --steps N [--set ...]... [--output FILE.json]
// asperity-bench compare DECK --steps N [--set ...]... [--output FILE.json]
// asperity-bench stiffness DECK.xml [--set ...]... [--output FILE.txt]
// asperity-bench mesh DECK.xml [--set ...]...
#include "Commands.hpp"
#include "base/Errors.hpp"
#include "base/program/MpiScope.hpp"
#include "base/program/Plugins.hpp"
#include "measuring/CountedProducts.hpp"
#include "scenario/Registrations.hpp"

#include <iostream>

int main(int argc, char** argv)
{
  // 1. Start MPI and Kokkos.
  CountedProducts::prepare();
  asperity::MpiScope parallel(argc, argv);
  auto const& communicator = parallel.communicator();
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
      // 3. Measure.
      return measure(arguments, communicator);
    },
    "asperity-bench");
}
