#include "Commands.hpp"

#include "base/Errors.hpp"
#include "base/MpiScope.hpp"
#include "base/NearestName.hpp"

#include <functional>
#include <iostream>
#include <map>

// Makes meshes and converts those of Gmsh into Asperity's HDF5 files. A serial program: MPI is not
// started.
namespace
{
using Command = std::function<void(std::vector<std::string> const&)>;

void printHelp()
{
  std::cout << "asperity-mesh makes and converts meshes.\n\n"
               "  asperity-mesh convert IN.msh OUT.h5 [--overwrite]\n"
               "    Gmsh's format to ours; physical groups become regions and boundaries.\n"
               "  asperity-mesh wedge OUT.h5 [--overwrite] [OPTION VALUE]...\n"
               "    The subduction wedge of Pipping 2014, A.1, by bisection. Options:\n"
            << wedgeOptions()
            << "  asperity-mesh rectangle OUT.h5 [--overwrite] [OPTION VALUE]...\n"
               "    A rectangle of right triangles, graded by bisection. Options:\n"
            << rectangleOptions()
            << "  asperity-mesh info FILE.h5\n"
               "    Counts, sizes, regions and boundaries of a mesh.\n\n"
               "Exit status: 0 done, 2 the input is at fault.\n";
}

void run(std::vector<std::string> const& words)
{
  const std::map<std::string, Command> commands = {
    {"convert", convert}, {"wedge", makeWedge}, {"rectangle", makeRectangle}, {"info", printInfo}};
  ASPERITY_REQUIRE(!words.empty(), "A command is missing. See asperity-mesh --help.");
  const auto found = commands.find(words[0]);
  ASPERITY_REQUIRE(found != commands.end(),
                   "Unknown command '"
                     << words[0] << "'."
                     << asperity::didYouMean(words[0], {"convert", "wedge", "rectangle", "info"}));
  found->second({words.begin() + 1, words.end()});
}
} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (auto const& word : words) {
    if (word == "--help" || word == "-h") {
      printHelp();
      return asperity::exit_done;
    }
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
