#include "scenario/deck/CommandLine.hpp"

#include "portability/Backend.hpp"
#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <sstream>

namespace
{
using namespace asperity;
using namespace asperity::test;

CommandLine parse(std::vector<char const*> arguments)
{
  arguments.insert(arguments.begin(), "asperity");
  return parseCommandLine(static_cast<int>(arguments.size()), arguments.data());
}

std::string refused(std::vector<char const*> const& arguments)
{
  return refusal([&] { parse(arguments); });
}

TEST(CommandLine, EveryOption)
{
  const auto line = parse({"--set", "Friction/a=0.1", "deck.xml", "--set=b/c=x == 1", "--output",
                           "out", "--restart=a.h5", "--validate", "--overwrite", "--overlay",
                           "short.xml", "--plugin", "libone.so", "--plugin=libtwo.so"});
  EXPECT_EQ(line.plugins, (std::vector<std::string>{"libone.so", "libtwo.so"}));
  EXPECT_EQ(line.deck, "deck.xml");
  EXPECT_EQ(line.overrides, (std::vector<std::string>{"Friction/a=0.1", "b/c=x == 1"}));
  EXPECT_EQ(line.overlays, (std::vector<std::string>{"short.xml"}));
  EXPECT_EQ(line.output, "out");
  EXPECT_EQ(line.restart, "a.h5");
  EXPECT_TRUE(line.validate && line.overwrite);
  EXPECT_FALSE(line.print_parameters || line.help);
}

TEST(CommandLine, WithoutOptions)
{
  const auto line = parse({"deck.xml"});
  EXPECT_TRUE(line.output.empty() && line.restart.empty() && line.overrides.empty());
  EXPECT_FALSE(line.validate || line.overwrite);
}

TEST(CommandLine, WithoutADeck)
{
  EXPECT_EQ(parse({"--print-parameters"}).format, ParameterFormat::text);
  EXPECT_EQ(parse({"--print-parameters", "--format=xml"}).format, ParameterFormat::xml);
  EXPECT_TRUE(parse({"--help"}).help);
  EXPECT_TRUE(parse({"-h"}).help);
  expectParts(refused({}), {"No deck", "--help"});
  expectParts(refused({"--validate"}), {"No deck"});
}

TEST(CommandLine, ARestartTakesFromTheRunWhatIsNotGiven)
{
  const asperity::test::TemporaryDirectory directory;
  directory.write("parameters.xml", "");
  const auto run = directory.file("");
  auto line = parse({"--restart", run.c_str(), "--set", "a=1", "--remove", "b/c"});
  completeRestart(line);
  EXPECT_EQ(line.removals, std::vector<std::string>{"b/c"});
  EXPECT_TRUE(std::filesystem::equivalent(line.deck, directory.file("parameters.xml")));
  EXPECT_EQ(std::filesystem::path(line.restart), std::filesystem::path(run) / "checkpoint.h5");
  EXPECT_TRUE(std::filesystem::equivalent(line.output, run));

  const auto file = directory.write("older.h5", "");
  line = parse({"--restart", file.c_str()});
  completeRestart(line);
  EXPECT_EQ(line.restart, file);
  EXPECT_EQ(line.deck, directory.file("parameters.xml"));

  line = parse({"deck.xml", "--restart", file.c_str(), "--output", "out"});
  completeRestart(line);
  EXPECT_EQ(line.deck, "deck.xml");
  EXPECT_EQ(line.output, "out");

  std::filesystem::remove(directory.file("parameters.xml"));
  line = parse({"--restart", file.c_str()});
  expectRefusal([&] { completeRestart(line); },
                {"--restart " + file, "parameters.xml", "not there", "name the deck"});
  line = parse({"--restart", "nowhere"});
  expectRefusal([&] { completeRestart(line); },
                {"--restart nowhere: there is no such directory or file", "checkpoint.h5"});
}

// What Kokkos knows, MpiScope has taken out: unit.base.Guard.
TEST(CommandLine, RefusesWhatKokkosDoesNotKnow)
{
  expectParts(refused({"deck.xml", "--kokkos-treads=4"}),
              {"--kokkos-treads is unknown to Kokkos " + kokkosVersion(), "threads'"});
  expectParts(refused({"--kokkos-colour", "deck.xml"}), {"--kokkos-colour is unknown"});
}

TEST(CommandLine, VersionNeedsNoDeck) { EXPECT_TRUE(parse({"--version"}).version); }

TEST(CommandLine, Refusals)
{
  expectParts(refused({"deck.xml", "--overwirte"}), {"--overwirte is unknown", "'--overwrite'"});
  expectParts(refused({"deck.xml", "--colour"}), {"--colour is unknown"});
  expectParts(refused({"deck.xml", "-x"}), {"-x is unknown"});
  expectParts(refused({"deck.xml", "--output"}), {"--output needs a value"});
  expectParts(refused({"deck.xml", "--output", "--validate"}), {"--output needs a value"});
  expectParts(refused({"deck.xml", "--output="}), {"--output needs a value"});
  expectParts(refused({"deck.xml", "--output", "a", "--output=b"}),
              {"--output is given twice", "'a'", "'b'"});
  expectParts(refused({"deck.xml", "--outputs=a"}), {"--outputs is unknown", "'--output'"});
  expectParts(refused({"deck.xml", "--validate=yes"}), {"--validate takes no value", "'yes'"});
  expectParts(refused({"one.xml", "two.xml"}), {"'one.xml'", "'two.xml'", "--overlay"});
  expectParts(refused({"--print-parameters", "--format=xlm"}), {"'xlm' is unknown", "'xml'"});
}

TEST(CommandLine, HelpNamesEveryOption)
{
  std::ostringstream out;
  printHelp(out);
  expectParts(out.str(), {"--set", "--overlay", "--plugin", "--output", "--restart", "--overwrite",
                          "--validate", "--print-parameters", "--format", "--help", "--kokkos",
                          "Exit status"});
}
} // namespace
