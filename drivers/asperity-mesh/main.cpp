#include "Plugins.hpp"
#include "commands/Commands.hpp"

#include "base/Errors.hpp"
#include "base/program/MpiScope.hpp"

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

// Makes meshes, converts those of other programs, and partitions them. MPI is not started.
int main(int argc, char** argv)
try {
  const std::vector<std::string> help = {"--help", "-h"};
  const auto words = asperity::geometry::loadPlugins({argv + 1, argv + argc});
  if (std::find_first_of(words.begin(), words.end(), help.begin(), help.end()) != words.end()) {
    asperity::geometry::printHelp();
  } else {
    asperity::geometry::runCommand(words);
  }
  return asperity::exit_done;
} catch (std::exception const& error) {
  std::cerr << "asperity-mesh: " << error.what() << '\n';
  asperity::exitIfHdf5HasUnclosed(asperity::exitStatus(error));
  return asperity::exitStatus(error);
}
