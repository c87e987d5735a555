#include "commands/Commands.hpp"

#include "FormatChoice.hpp"
#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"

#include <algorithm>
#include <iostream>

namespace asperity::geometry
{
namespace
{
struct Command
{
  std::string name, files, meaning;
  void (*run)(Arguments&);
};

std::vector<Command> commands()
{
  return {
    {"build", "[MODEL.xml] OUT.h5", "Makes a mesh from surfaces of faults and ground.", build},
    {"convert", "IN OUT.h5",
     "Converts a mesh of another program or meshes a geometry: " + describeFormats<MeshFormat>() +
       ". Groups become regions, boundaries and, where inside, faults.",
     convert},
    {"wedge", "OUT.h5", "Makes the subduction wedge of Pipping 2014, A.1, by bisection.",
     makeWedge},
    {"rectangle", "OUT.h5", "Makes a rectangle of right triangles, graded by bisection.",
     makeRectangle},
    {"box", "OUT.h5", "Makes a box of bricks of six tetrahedra each, graded by bisection.",
     makeBox},
    {"partition", "FILE.h5",
     "Divides a mesh, partitioned before or not, into parts for ranks, after it has been "
     "split\n    along its faults. A mesh that is partitioned again keeps boundary and "
     "weight.",
     partition},
    {"info", "FILE.h5",
     "Prints counts after the split along the faults, sizes, regions, boundaries and faults.",
     printInfo}};
}

} // namespace

void printHelp()
{
  std::cout << "asperity-mesh makes, converts and partitions meshes.\n";
  for (auto const& command : commands()) {
    Arguments arguments(std::nullopt);
    command.run(arguments);
    std::cout << "\n  asperity-mesh " << command.name << ' ' << command.files << " [options]\n    "
              << command.meaning << '\n'
              << arguments.help();
  }
  std::cout << "\nEvery command takes --plugin LIBRARY, which brings a format of meshes of your "
               "own; may be repeated.\n"
               "Exit status: 0 done, 2 the input is at fault, 5 a file cannot be written.\n";
}

void runCommand(std::vector<std::string> const& words)
{
  ASPERITY_REQUIRE(!words.empty(), "A command is missing. See asperity-mesh --help.");
  std::vector<std::string> names;
  for (auto const& command : commands()) {
    names.push_back(command.name);
    if (command.name == words[0]) {
      Arguments arguments(std::vector(words.begin() + 1, words.end()));
      return command.run(arguments);
    }
  }
  throw InputError("Unknown command '" + words[0] + "'." + didYouMean(words[0], names));
}
} // namespace asperity::geometry
