#include "BenchArguments.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/program/Options.hpp"

#include <algorithm>
#include <ostream>
#include <vector>

namespace
{
void declare(asperity::Options& options, BenchArguments& arguments, std::string& steps)
{
  options.value("--steps", steps, "N", "steps: the number of accepted steps")
    .values("--set", arguments.deck.overrides, "\"PATH=value\"", "change the deck")
    .values("--plugin", arguments.deck.plugins, "LIBRARY", "load laws of your own")
    .value("--output", arguments.output, "FILE",
           "write the numbers to a file, too: as JSON, for stiffness as text")
    .flag("-h,--help", arguments.help, "print this text");
}
} // namespace

BenchArguments parseBenchArguments(int argc, char const* const* argv)
{
  BenchArguments arguments;
  std::string steps;
  asperity::Options options;
  declare(options, arguments, steps);
  auto const words = options.parse(asperity::wordsOf(argc, argv));
  if (arguments.help) {
    return arguments;
  }
  const std::vector<std::string> commands = {"steps", "kernels", "stiffness"};
  ASPERITY_REQUIRE(words.size() == 2 &&
                     std::find(commands.begin(), commands.end(), words[0]) != commands.end(),
                   "Give one of the commands steps, kernels and stiffness, and then DECK.xml. "
                   "See asperity-bench --help.");
  arguments.command = words[0];
  arguments.deck.deck = words[1];
  if (arguments.command != "steps") {
    ASPERITY_REQUIRE(steps.empty(), "asperity-bench " << arguments.command
                                                      << " takes only the options --set, --plugin "
                                                         "and --output.");
    return arguments;
  }
  ASPERITY_REQUIRE(!steps.empty(), "--steps is needed, e.g. --steps 20.");
  auto const number = asperity::readInteger(steps);
  ASPERITY_REQUIRE(number && *number >= 1 && *number <= 1000000,
                   "--steps " << steps << " is not a whole number of steps from 1 to 1e6.");
  arguments.num_steps = *number;
  return arguments;
}

void printBenchHelp(std::ostream& out)
{
  BenchArguments arguments;
  std::string steps;
  asperity::Options options;
  declare(options, arguments, steps);
  out
    << "asperity-bench measures what the solver costs, and what a mesh does to a fault.\n\n"
       "  asperity-bench steps DECK.xml --steps N\n"
       "    The first N accepted steps of a deck, without outputs: what a coupled step costs, in\n"
       "    counts and in products with K; set-up and memory; the time of each kind of work.\n\n"
       "  asperity-bench kernels DECK.xml\n"
       "    How fast products, sweeps, transfers, V-cycles and friction's kernels run on the\n"
       "    matrices of a deck, in bytes that they have to move, beside a STREAM triad.\n\n"
       "  asperity-bench stiffness DECK.xml\n"
       "    How slip stresses the fault of a deck on its mesh: the error of waves of slip\n"
       "    against a homogeneous half space. In the plane, --output FILE.txt has the\n"
       "    condensed matrix, for numpy.loadtxt: position, weight, a row of traction [Pa/m] and\n"
       "    one of compression. In space the fault has to be plane, a boundary of the body, and\n"
       "    27 cells wide or more.\n"
    << options.help()
    << "\nExit status: 0 done, 2 the input is at fault; others as for asperity.\n";
}
