#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <cctype>

namespace asperity::geometry
{
namespace
{
// "a, b LAST c", where LAST is " or " for example.
std::string joined(std::vector<std::string> const& words, std::string const& last)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : last) + words[i];
  }
  return text;
}
} // namespace

std::vector<std::string> ReadOptions::valuesOf(std::string const& option) const
{
  const auto found = own.find(option);
  return found == own.end() ? std::vector<std::string>() : found->second;
}

std::string ReadOptions::valueOf(std::string const& option) const
{
  const auto values = valuesOf(option);
  return values.empty() ? "" : values.front();
}

bool hasEnding(std::string const& file_name, std::string const& ending)
{
  return file_name.size() >= ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), file_name.rbegin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) ==
                  std::tolower(static_cast<unsigned char>(b));
         });
}

FoundFormat formatOf(std::string const& file_name)
{
  auto const& registry = MeshFormatRegistry::instance();
  FoundFormat found = {"", nullptr};
  std::size_t longest = 0;
  for (auto const& name : registry.names()) {
    auto const& format = registry.at(name);
    for (auto const& ending : format.endings()) {
      if (hasEnding(file_name, ending) && ending.size() > longest) {
        found = {name, &format};
        longest = ending.size();
      }
    }
  }
  ASPERITY_REQUIRE(found.format != nullptr,
                   "'" << file_name << "' is in no format that can be converted, by its name. "
                       << "Names end with one of " << joined(knownEndings(), ", ")
                       << ". The program meshio (Debian: meshio-tools) makes such files of others: "
                          "meshio convert IN OUT.vtu. A format of your own comes with --plugin. "
                          "Surfaces of faults and ground are for asperity-mesh build.");
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

std::string knownFormats()
{
  auto const& registry = MeshFormatRegistry::instance();
  std::vector<std::string> formats;
  for (auto const& name : registry.names()) {
    formats.push_back(name + " (" + joined(registry.at(name).endings(), ", ") + ")");
  }
  return joined(formats, " or ");
}
} // namespace asperity::geometry
