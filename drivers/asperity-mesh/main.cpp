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

void printHelp()
{
  std::cout
    << "asperity-mesh makes, converts and partitions meshes.\n\n"
       "  asperity-mesh convert IN.msh OUT.h5 [--overwrite]\n"
       "    Converts Gmsh's format to ours; physical groups become regions and boundaries.\n"
       "  asperity-mesh wedge OUT.h5 [--overwrite] [OPTION VALUE]...\n"
       "    Makes the subduction wedge of Pipping 2014, A.1, by bisection. Options:\n"
    << wedgeOptions()
    << "  asperity-mesh rectangle OUT.h5 [--overwrite] [OPTION VALUE]...\n"
       "    Makes a rectangle of right triangles, graded by bisection. Options:\n"
    << rectangleOptions()
    << "  asperity-mesh box OUT.h5 [--overwrite] [OPTION VALUE]...\n"
       "    Makes a box of bricks of six tetrahedra each, graded by bisection. Options:\n"
    << boxOptions()
    << "  asperity-mesh partition FILE.h5 --parts N --output OUT.h5 [--overwrite]\n"
       "                [--boundary NAME] [--boundary-weight W]\n"
       "    Divides a mesh, partitioned before or not, into N parts for N ranks.\n"
       "    The parts also get equal shares of the vertices of the boundary, which is the fault; "
       "they\n"
       "    count W times in the balance (4). A mesh that is partitioned again keeps both "
       "options.\n"
       "  asperity-mesh info FILE.h5\n"
       "    Prints counts, sizes, regions and boundaries of a mesh, partitioned or not.\n\n"
       "Exit status: 0 done, 2 the input is at fault.\n";
}

void run(std::vector<std::string> const& words)
{
  const std::map<std::string, Command> commands = {
    {"convert", convert},         {"box", makeBox},         {"wedge", makeWedge},
    {"rectangle", makeRectangle}, {"partition", partition}, {"info", printInfo}};
  std::vector<std::string> names;
  for (auto const& command : commands) {
    names.push_back(command.first);
  }
  ASPERITY_REQUIRE(!words.empty(), "A command is missing. See asperity-mesh --help.");
  const auto found = commands.find(words[0]);
  const std::string hint = asperity::didYouMean(words[0], names);
  ASPERITY_REQUIRE(found != commands.end(), "Unknown command '" << words[0] << "'." << hint);
  found->second({words.begin() + 1, words.end()});
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
    std::cerr << "asperity-mesh: " << error.what() << '\n';
    return asperity::exit_input;
  } catch (std::exception const& error) {
    std::cerr << "asperity-mesh: " << error.what() << '\n';
    return asperity::exit_other;
  }
}
