#include "Commands.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/program/MpiScope.hpp"

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

// Makes meshes, converts those of Gmsh into Asperity's HDF5 files, and partitions them. A serial
// program: MPI is not started.
namespace
{
using Command = std::function<void(std::vector<std::string> const&)>;

void run(std::vector<std::string> const& words)
{
  const std::map<std::string, Command> commands = {
    {"convert", convert},         {"box", makeBox},         {"wedge", makeWedge},
    {"rectangle", makeRectangle}, {"partition", partition}, {"info", printInfo}};
  ASPERITY_REQUIRE(!words.empty(), "A command is missing. See asperity-mesh --help.");
  const auto found = commands.find(words[0]);
  const std::string hint =
    asperity::didYouMean(words[0], {"convert", "box", "wedge", "rectangle", "partition", "info"});
  ASPERITY_REQUIRE(found != commands.end(), "Unknown command '" << words[0] << "'." << hint);
  found->second({words.begin() + 1, words.end()});
}

int report(std::exception const& error, int status)
{
  std::cerr << "asperity-mesh: " << error.what() << '\n';
  asperity::leaveIfHdf5Cannot(status);
  return status;
}
} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::vector<std::string> help = {"--help", "-h"};
  if (std::find_first_of(words.begin(), words.end(), help.begin(), help.end()) != words.end()) {
    printHelp();
    return asperity::exit_done;
  }
  try {
    run(words);
    return asperity::exit_done;
  } catch (asperity::InputError const& error) {
    return report(error, asperity::exit_input);
  } catch (asperity::OutputError const& error) {
    return report(error, asperity::exit_output);
  } catch (std::exception const& error) {
    return report(error, asperity::exit_other);
  }
}
