#include "commands/Commands.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"

#include <iostream>

namespace asperity::geometry
{
namespace
{
// In the order of --help.
constexpr std::unique_ptr<Command> (*commands[])() = {
  buildCommand, convertCommand,   wedgeCommand, rectangleCommand,
  boxCommand,   partitionCommand, infoCommand};
} // namespace

void printHelp()
{
  std::cout << "asperity-mesh makes, converts and partitions meshes.\n";
  for (auto const make : commands) {
    const auto command = make();
    const auto text = command->text();
    Arguments arguments;
    command->declareOptions(arguments);
    std::cout << "\n  asperity-mesh " << text.name << ' ' << text.usage << " [options]\n    "
              << text.meaning << '\n'
              << arguments.help();
  }
  std::cout << "\nEvery command takes --plugin LIBRARY, which adds formats of meshes, surfaces and "
               "grids and kinds of surface of your own; may be repeated.\n"
               "Exit status: 0 done, 2 the input is at fault, 5 a file cannot be written.\n";
}

void runCommand(std::vector<std::string> const& words)
{
  ASPERITY_REQUIRE(!words.empty(), "A command is missing. See asperity-mesh --help.");
  std::vector<std::string> names;
  for (auto const make : commands) {
    const auto command = make();
    const auto text = command->text();
    if (text.name == words[0]) {
      Arguments arguments;
      command->declareOptions(arguments);
      arguments.read({words.begin() + 1, words.end()}, text.files,
                     text.fewest_files.value_or(text.files.size()));
      return command->run(arguments);
    }
    names.push_back(text.name);
  }
  throw InputError("Unknown command '" + words[0] + "'." + didYouMean(words[0], names));
}
} // namespace asperity::geometry
