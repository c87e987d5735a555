#include "BenchArguments.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/program/Options.hpp"

#include <cmath>
#include <ostream>

using asperity::readNumber;

namespace
{
double positive(std::string const& option, std::string const& text)
{
  auto const number = readNumber(text);
  ASPERITY_REQUIRE(number && *number > 0, option << " " << text << " is not a positive number.");
  return *number;
}

std::vector<double> positives(std::string const& option, std::string const& text)
{
  std::vector<double> numbers;
  for (auto const& piece : asperity::split(text, ',')) {
    numbers.push_back(positive(option, piece));
  }
  return numbers;
}

// The texts on the command line; "" for options that are not given.
struct Given
{
  std::string sizes, steps, rupture_rate;
};

void declare(asperity::Options& options, BenchArguments& arguments, Given& given)
{
  options.value("--sizes", given.sizes, "H,H,...", "cell sizes of the meshes, from coarse to fine")
    .value("--steps", given.steps, "TAU,TAU,...",
           "scaling: step sizes, s; steps, compare: a number of accepted steps")
    .value("--size-parameter", arguments.scaling.cell_size, "PATH",
           "the deck's parameter that the sizes are given to (Mesh/Deep Wedge/Cell Size)")
    .value("--rupture-rate", given.rupture_rate, "V", "slip rate of the rupture, m/s (0.01)")
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
  Given given;
  asperity::Options options;
  declare(options, arguments, given);
  auto const words = options.parse(asperity::wordsOf(argc, argv));
  if (arguments.help) {
    return arguments;
  }
  ASPERITY_REQUIRE(
    words.size() == 2 && (words[0] == "scaling" || words[0] == "steps" || words[0] == "compare" ||
                          words[0] == "stiffness" || words[0] == "mesh"),
    "Give one of the commands scaling, steps, compare, stiffness and mesh, and then DECK.xml. "
    "See asperity-bench --help.");
  arguments.deck.deck = words[1];
  arguments.counts_mesh = words[0] == "mesh";
  if (arguments.counts_mesh) {
    ASPERITY_REQUIRE(given.sizes.empty() && given.steps.empty() && given.rupture_rate.empty() &&
                       arguments.output.empty(),
                     "asperity-bench mesh takes only the options --set and --plugin.");
    return arguments;
  }
  arguments.writes_stiffness = words[0] == "stiffness";
  if (arguments.writes_stiffness) {
    ASPERITY_REQUIRE(given.sizes.empty() && given.steps.empty() && given.rupture_rate.empty(),
                     "asperity-bench stiffness takes only the options --set, --plugin and "
                     "--output.");
    return arguments;
  }
  if (words[0] == "steps" || words[0] == "compare") {
    ASPERITY_REQUIRE(!given.steps.empty(), "--steps is needed, e.g. --steps 20.");
    const double number = positive("--steps", given.steps);
    ASPERITY_REQUIRE(number >= 1 && number <= 1e6 && number == std::floor(number),
                     "--steps " << given.steps << " is not a whole number of steps from 1 to 1e6.");
    (words[0] == "steps" ? arguments.steps.num_steps : arguments.compare.num_steps) =
      static_cast<int>(number);
    return arguments;
  }
  ASPERITY_REQUIRE(!given.sizes.empty() && !given.steps.empty(),
                   "--sizes and --steps are needed, e.g. --sizes 0.02,0.01 --steps 1,1e-3.");
  arguments.scaling.sizes = positives("--sizes", given.sizes);
  arguments.scaling.steps = positives("--steps", given.steps);
  if (!given.rupture_rate.empty()) {
    arguments.scaling.rupture_rate = positive("--rupture-rate", given.rupture_rate);
  }
  return arguments;
}

void printBenchHelp(std::ostream& out)
{
  BenchArguments arguments;
  Given given;
  asperity::Options options;
  declare(options, arguments, given);
  out
    << "asperity-bench measures what the solver costs.\n\n"
       "  asperity-bench scaling DECK.xml --sizes H,H,... --steps TAU,TAU,...\n"
       "    Rate problems of a stuck, a nucleating and a rupturing fault with each step size [s],\n"
       "    on meshes from coarse to fine, solved from rest: TNNMG iterations, V-cycles, seconds\n"
       "    and memory. The deck is three-dimensional with a plane fault.\n\n"
       "  asperity-bench steps DECK.xml --steps N\n"
       "    The first N accepted steps of a three-dimensional deck: what a coupled step costs, in\n"
       "    counts and in products with K, for inertial and for quasi-static steps; set-up and\n"
       "    memory.\n\n"
       "  asperity-bench compare DECK.xml --steps N\n"
       "    After each of N accepted steps: a coupled step, its rate problem, and the linear\n"
       "    problem with the same matrix, guess and error by CG with MueLu's multigrid.\n\n"
       "  asperity-bench stiffness DECK.xml\n"
       "    How slip stresses the fault of a deck in the plane on its mesh: the error of the\n"
       "    traction of waves of slip, and with --output FILE.txt the condensed matrix, for\n"
       "    numpy.loadtxt: position, weight, a row of traction [Pa/m] and one of compression.\n\n"
       "  asperity-bench mesh DECK.xml\n"
       "    Makes the mesh alone: how many cells and vertices, how evenly the ranks have them, "
       "and\n"
       "    how much memory it takes.\n"
    << options.help()
    << "\nExit status: 0 done, 2 the input is at fault; others as for asperity.\n";
}
