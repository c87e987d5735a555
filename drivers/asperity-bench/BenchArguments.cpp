#include "BenchArguments.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <ostream>

using asperity::readNumber;

namespace
{
const std::vector<std::string> options = {"--sizes", "--steps",  "--size-parameter",
                                          "--set",   "--output", "--rupture-rate"};

double positive(std::string const& option, std::string const& text)
{
  auto const number = readNumber(text);
  ASPERITY_REQUIRE(number && *number > 0, option << " " << text << ": this is no positive number.");
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

void read(std::string const& option, std::string const& value, BenchArguments& arguments)
{
  if (option == "--sizes") {
    arguments.scaling.sizes = positives(option, value);
  } else if (option == "--steps") {
    arguments.scaling.steps = positives(option, value);
  } else if (option == "--size-parameter") {
    arguments.scaling.cell_size = value;
  } else if (option == "--rupture-rate") {
    arguments.scaling.rupture_rate = positive(option, value);
  } else if (option == "--set") {
    arguments.deck.overrides.push_back(value);
  } else {
    arguments.output = value;
  }
}
} // namespace

BenchArguments parseBenchArguments(int argc, char const* const* argv)
{
  BenchArguments arguments;
  std::vector<std::string> words(argv + 1, argv + argc), names;
  for (std::size_t i = 0; i < words.size(); ++i) {
    auto const& word = words[i];
    if (word == "--help" || word == "-h") {
      arguments.help = true;
      return arguments;
    }
    if (word.rfind("--", 0) != 0) {
      names.push_back(word);
      continue;
    }
    ASPERITY_REQUIRE(std::find(options.begin(), options.end(), word) != options.end(),
                     "Unknown option '" << word << "'." << asperity::didYouMean(word, options));
    ASPERITY_REQUIRE(i + 1 < words.size(), word << " needs a value.");
    read(word, words[++i], arguments);
  }
  ASPERITY_REQUIRE(names.size() == 2 && names[0] == "scaling",
                   "asperity-bench scaling DECK.xml is what there is. See asperity-bench --help.");
  ASPERITY_REQUIRE(!arguments.scaling.sizes.empty() && !arguments.scaling.steps.empty(),
                   "--sizes and --steps are needed, e.g. --sizes 0.02,0.01 --steps 1,1e-3.");
  arguments.deck.deck = names[1];
  return arguments;
}

void printBenchHelp(std::ostream& out)
{
  out
    << "asperity-bench measures what the solver costs.\n\n"
       "  asperity-bench scaling DECK.xml --sizes H,H,... --steps TAU,TAU,...\n"
       "    Rate problems of a stuck, a nucleating and a rupturing fault with each step size [s],\n"
       "    on meshes from coarse to fine, solved from rest: TNNMG iterations, V-cycles, seconds\n"
       "    and memory. The deck is three-dimensional with a plane fault.\n"
       "      --size-parameter PATH   the deck's parameter that the sizes are given to\n"
       "                              (Mesh/Deep Wedge/Cell Size)\n"
       "      --rupture-rate V        slip rate of the rupture, m/s (0.01)\n"
       "      --set \"PATH=value\"      changes the deck; may be repeated\n"
       "      --output FILE.json      the same numbers for programs\n\n"
       "Exit status: 0 done, 2 the input is at fault.\n";
}
