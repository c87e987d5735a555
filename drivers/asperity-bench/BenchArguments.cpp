#include "BenchArguments.hpp"
#include "Kernels.hpp"
#include "Steps.hpp"
#include "Stiffness.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/program/Options.hpp"

#include <algorithm>
#include <ostream>
#include <vector>

namespace asperity::bench
{
namespace
{
const std::vector<BenchCommand> commands = {
  {"steps", " --steps N",
   "    The first N accepted steps of a deck, without outputs: what a coupled step costs, in\n"
   "    counts and in products with K; set-up and memory; the time of each kind of work.\n",
   true,
   [](ParameterList const& deck, BenchArguments const& arguments,
      RCP<const Communicator> const& communicator) {
     return measureSteps(deck, arguments.num_steps, communicator);
   }},
  {"kernels", "",
   "    How fast products, sweeps, transfers, V-cycles and friction's kernels run on the\n"
   "    matrices of a deck, in bytes that they have to move, beside a STREAM triad.\n",
   false,
   [](ParameterList const& deck, BenchArguments const&,
      RCP<const Communicator> const& communicator) { return measureKernels(deck, communicator); }},
  {"stiffness", "",
   "    How slip stresses the fault of a deck on its mesh: the error of waves of slip\n"
   "    against a homogeneous half space. In the plane, --output FILE.txt has the\n"
   "    condensed matrix, for numpy.loadtxt: position, weight, a row of traction [Pa/m] and\n"
   "    one of compression. In space the fault has to be plane, a boundary of the body, and\n"
   "    27 cells wide or more.\n",
   false,
   [](ParameterList const& deck, BenchArguments const&,
      RCP<const Communicator> const& communicator) {
     return measureStiffness(deck, communicator);
   }}};

// "steps, kernels and stiffness"
std::string names()
{
  std::string text;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < commands.size() ? ", " : " and ") + commands[i].name;
  }
  return text;
}

void declare(Options& options, BenchArguments& arguments, std::string& steps)
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
  Options options;
  declare(options, arguments, steps);
  auto const words = options.parse(wordsOf(argc, argv));
  if (arguments.help) {
    return arguments;
  }
  const auto command = std::find_if(commands.begin(), commands.end(), [&](auto const& one) {
    return words.size() == 2 && one.name == words[0];
  });
  ASPERITY_REQUIRE(command != commands.end(),
                   "Give one of the commands "
                     << names() << ", and then DECK.xml. See asperity-bench --help.");
  arguments.command = &*command;
  arguments.deck.deck = words[1];
  if (!command->counts_steps) {
    ASPERITY_REQUIRE(steps.empty(), "asperity-bench " << command->name
                                                      << " takes only the options --set, --plugin "
                                                         "and --output.");
    return arguments;
  }
  ASPERITY_REQUIRE(!steps.empty(), "--steps is needed, e.g. --steps 20.");
  auto const number = readInteger(steps);
  ASPERITY_REQUIRE(number && *number >= 1 && *number <= 1000000,
                   "--steps " << steps << " is not a whole number of steps from 1 to 1e6.");
  arguments.num_steps = *number;
  return arguments;
}

void printBenchHelp(std::ostream& out)
{
  BenchArguments arguments;
  std::string steps;
  Options options;
  declare(options, arguments, steps);
  out << "asperity-bench measures what the solver costs, and what a mesh does to a fault.\n\n";
  for (auto const& command : commands) {
    out << "  asperity-bench " << command.name << " DECK.xml" << command.arguments << '\n'
        << command.meaning << '\n';
  }
  out << options.help()
      << "\nExit status: 0 done, 2 the input is at fault; others as for asperity.\n";
}
} // namespace asperity::bench
