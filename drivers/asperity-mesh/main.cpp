#include "Commands.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/program/MpiScope.hpp"

#include <algorithm>
#include <iostream>

// Makes meshes, converts those of other programs, and partitions them. MPI is not started.
namespace
{
struct Command
{
  std::string name, files, meaning;
  void (*run)(Arguments&);
};

const std::vector<Command> commands = {
  {"build", "[MODEL.xml] OUT.h5", "Makes a mesh from surfaces of faults and ground.", build},
  {"convert", "IN OUT.h5",
   "Converts a mesh of Gmsh, SeisSol, Exodus, Abaqus or VTK, or meshes a .geo file, which is\n"
   "    executed: trust it first. Groups become regions, boundaries and, where inside, faults.",
   convert},
  {"wedge", "OUT.h5", "Makes the subduction wedge of Pipping 2014, A.1, by bisection.", makeWedge},
  {"rectangle", "OUT.h5", "Makes a rectangle of right triangles, graded by bisection.",
   makeRectangle},
  {"box", "OUT.h5", "Makes a box of bricks of six tetrahedra each, graded by bisection.", makeBox},
  {"partition", "FILE.h5",
   "Divides a mesh, partitioned before or not, into parts for ranks, after it has been split\n"
   "    along its faults. A mesh that is partitioned again keeps boundary and weight.",
   partition},
  {"info", "FILE.h5",
   "Prints counts after the split along the faults, sizes, regions, boundaries and faults.",
   printInfo}};

void printHelp()
{
  std::cout << "asperity-mesh makes, converts and partitions meshes.\n";
  for (auto const& command : commands) {
    Arguments arguments(std::nullopt);
    command.run(arguments);
    std::cout << "\n  asperity-mesh " << command.name << ' ' << command.files << " [options]\n    "
              << command.meaning << '\n'
              << arguments.help();
  }
  std::cout << "\nExit status: 0 done, 2 the input is at fault, 5 a file cannot be written.\n";
}

void run(std::vector<std::string> const& words)
{
  ASPERITY_REQUIRE(!words.empty(), "A command is missing. See asperity-mesh --help.");
  std::vector<std::string> names;
  for (auto const& command : commands) {
    names.push_back(command.name);
    if (command.name == words[0]) {
      Arguments arguments(std::vector(words.begin() + 1, words.end()));
      return command.run(arguments);
    }
  }
  throw asperity::InputError("Unknown command '" + words[0] + "'." +
                             asperity::didYouMean(words[0], names));
}
} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc), help = {"--help", "-h"};
  try {
    std::find_first_of(words.begin(), words.end(), help.begin(), help.end()) != words.end()
      ? printHelp()
      : run(words);
    return asperity::exit_done;
  } catch (std::exception const& error) {
    std::cerr << "asperity-mesh: " << error.what() << '\n';
    asperity::exitIfHdf5HasUnclosed(asperity::exitStatus(error));
    return asperity::exitStatus(error);
  }
}
