#include "scenario/deck/CommandLine.hpp"

#include "base/NearestName.hpp"
#include "base/program/Options.hpp"

#include <filesystem>
#include <ostream>
#include <system_error>

namespace asperity
{
namespace
{
void declare(Options& options, CommandLine& line, std::string& format)
{
  options
    .values("--set", line.overrides, "\"Path/To/Parameter=value\"", "replace or add a parameter")
    .values("--overlay", line.overlays, "FILE", "lay a second short deck over the first")
    .values("--remove", line.removals, "\"Path/To/Entry\"",
            "take a parameter or a list out of the deck")
    .values("--plugin", line.plugins, "LIBRARY",
            "load laws and outputs of your own from a shared library")
    .value("--output", line.output, "DIR", "where the results go")
    .value(
      "--restart", line.restart, "DIR|FILE",
      "go on with the run in a directory, or from a checkpoint file; without a deck the run's own "
      "parameters.xml is taken")
    .value("--restart-from", line.restart_from, "RUN",
           "begin a new run with the state of another run (its directory or checkpoint), whose "
           "mesh and fields may differ")
    .flag("--overwrite", line.overwrite, "replace results that are already there")
    .flag("--validate", line.validate, "check deck and mesh, compute nothing")
    .flag("--print-parameters", line.print_parameters,
          "print every parameter with default, unit, range and meaning")
    .value("--format", format, "text|xml", "how --print-parameters writes")
    .flag("--version", line.version, "print the versions and what the program runs on")
    .flag("-h,--help", line.help, "print this text");
}

ParameterFormat readFormat(std::string const& word)
{
  ASPERITY_REQUIRE(word.empty() || word == "text" || word == "xml",
                   "--format = '" << word << "' is unknown." << didYouMean(word, {"text", "xml"}));
  return word == "xml" ? ParameterFormat::xml : ParameterFormat::text;
}
} // namespace

CommandLine parseCommandLine(int argc, char const* const* argv)
{
  CommandLine line;
  std::string format;
  Options options;
  declare(options, line, format);
  auto const decks = options.parse(wordsOf(argc, argv));
  line.format = readFormat(format);
  ASPERITY_REQUIRE(decks.size() <= 1, "Two decks are given, '"
                                        << decks[0] << "' and '" << decks[1]
                                        << "'. Lay one over the other with --overlay.");
  line.deck = decks.empty() ? "" : decks.front();
  ASPERITY_REQUIRE(line.restart.empty() || line.restart_from.empty(),
                   "--restart goes on with a run and --restart-from begins a new one. Give one of "
                   "the two.");
  ASPERITY_REQUIRE(
    !line.deck.empty() || !line.restart.empty() || line.help || line.version ||
      line.print_parameters,
    "No deck is given. Usage: asperity DECK.xml [options]; --help lists the options.");
  return line;
}

void completeRestart(CommandLine& line)
{
  namespace fs = std::filesystem;
  if (line.restart.empty()) {
    return;
  }
  std::error_code ignored;
  ASPERITY_REQUIRE(!line.deck.empty() || fs::exists(line.restart, ignored),
                   "--restart " << line.restart
                                << ": there is no such directory or file. Give the directory of a "
                                   "run, which has parameters.xml and checkpoint.h5, or a "
                                   "checkpoint.");
  fs::path checkpoint = line.restart;
  if (fs::is_directory(checkpoint, ignored)) {
    checkpoint /= "checkpoint.h5";
    line.restart = checkpoint.string();
  }
  const fs::path folder = checkpoint.has_parent_path() ? checkpoint.parent_path() : fs::path(".");
  if (line.output.empty()) {
    line.output = folder.string();
  }
  if (line.deck.empty()) {
    line.deck = (folder / "parameters.xml").string();
    ASPERITY_REQUIRE(fs::exists(line.deck, ignored),
                     "--restart " << line.restart << " without a deck needs '" << line.deck
                                  << "', which is not there. Is this the directory of a run? If it "
                                     "is, name the deck and every --set.");
  }
}

void printHelp(std::ostream& out)
{
  CommandLine line;
  std::string format;
  Options options;
  declare(options, line, format);
  out << "Usage: asperity DECK.xml [options]\n"
         "       asperity --restart DIR [options]\n"
         "       asperity --print-parameters [--format=text|xml] [--plugin LIBRARY]...\n"
         "\n"
         "Simulates the earthquakes that the deck describes.\n"
      << options.help()
      << "\n"
         "Kokkos takes its own options (--kokkos-help lists them).\n"
         "Exit status: 0 done, 2 the input is at fault, 3 a solve failed, 4 stopped by a signal, 5 "
         "a file cannot be written, 1 other.\n";
}
} // namespace asperity
