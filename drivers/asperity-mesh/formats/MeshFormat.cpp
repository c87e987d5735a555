#include "MeshFormat.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <cctype>

namespace
{
bool endsWith(std::string const& text, std::string const& ending)
{
  return text.size() >= ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), text.rbegin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) ==
                  std::tolower(static_cast<unsigned char>(b));
         });
}
} // namespace

FoundFormat formatOf(std::string const& file_name)
{
  auto const& registry = MeshFormatRegistry::instance();
  FoundFormat found = {nullptr, ""};
  for (auto const& name : registry.names()) {
    auto const& format = registry.at(name);
    for (auto const& ending : format.endings()) {
      if (endsWith(file_name, ending) && ending.size() > found.ending.size()) {
        found = {&format, ending};
      }
    }
  }
  std::string known;
  for (auto const& ending : knownEndings()) {
    known += (known.empty() ? "" : ", ") + ending;
  }
  ASPERITY_REQUIRE(found.format != nullptr,
                   "'" << file_name << "' is in no format that can be converted, by its name. "
                       << "Names end with one of " << known << ". The program meshio (Debian: "
                       << "meshio-tools) makes such files of others: meshio convert IN OUT.vtu. "
                          "Surfaces of faults and "
                       << "ground are for asperity-mesh build.");
  return found;
}

std::vector<std::string> knownEndings()
{
  auto const& registry = MeshFormatRegistry::instance();
  std::vector<std::string> endings;
  for (auto const& name : registry.names()) {
    for (auto const& ending : registry.at(name).endings()) {
      endings.push_back(ending);
    }
  }
  std::sort(endings.begin(), endings.end());
  return endings;
}
