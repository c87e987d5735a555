#include "Plugins.hpp"

#include "formats/MeshFormat.hpp"
#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/grids/GridFormat.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"

#include "base/Errors.hpp"
#include "base/program/Plugins.hpp"

namespace asperity::geometry
{
std::vector<std::string> registrations()
{
  std::vector<std::string> all;
  for (auto const& some : {MeshFormatRegistry::instance().registrations(),
                           SurfaceFormatRegistry::instance().registrations(),
                           GridFormatRegistry::instance().registrations(),
                           SurfaceKindRegistry::instance().registrations()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::vector<std::string> loadPlugins(std::vector<std::string> const& words)
{
  const std::string option = "--plugin";
  std::vector<std::string> files, others;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option) {
      ++i;
      ASPERITY_REQUIRE(i < words.size() && words[i].rfind("--", 0) != 0,
                       "The option " << option << " needs a value. Try --help.");
      files.push_back(words[i]);
    } else if (words[i].rfind(option + "=", 0) == 0) {
      files.push_back(words[i].substr(option.size() + 1));
    } else {
      others.push_back(words[i]);
    }
  }
  asperity::loadPlugins(files, registrations);
  return others;
}
} // namespace asperity::geometry
