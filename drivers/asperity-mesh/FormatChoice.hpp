#pragma once

#include "registry/Registry.hpp"

#include <algorithm>
#include <string>
#include <vector>

// The choice of a format by a file's name, for every kind of format that is registered: meshes,
// surfaces and grids. A format is a class with a function endings(), the ends of file names that it
// has, such as ".msh".
namespace asperity::geometry
{
// Whether a file's name ends with this, in lower or upper case.
bool hasEnding(std::string const& file_name, std::string const& ending);

// "a, b or c"
std::string alternatives(std::vector<std::string> const& words);

template <class Format>
struct NamedFormat
{
  std::string name; // of the format
  Format const* format = nullptr;
};

// The format that has the longest ending of the file's name; no format if none fits.
template <class Format>
NamedFormat<Format> findFormat(std::string const& file_name)
{
  auto const& registry = Registry<Format>::instance();
  NamedFormat<Format> found;
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
  return found;
}

// The endings of all formats, sorted.
template <class Format>
std::vector<std::string> endingsOf()
{
  auto const& registry = Registry<Format>::instance();
  std::vector<std::string> all;
  for (auto const& name : registry.names()) {
    auto const endings = registry.at(name).endings();
    all.insert(all.end(), endings.begin(), endings.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

// All formats with their endings, sorted by name: "OFF (.off), PLY (.ply) or STL (.stl)".
template <class Format>
std::string describeFormats()
{
  auto const& registry = Registry<Format>::instance();
  std::vector<std::string> formats;
  for (auto const& name : registry.names()) {
    std::string endings;
    for (auto const& ending : registry.at(name).endings()) {
      endings += (endings.empty() ? "" : ", ") + ending;
    }
    formats.push_back(name + " (" + endings + ")");
  }
  return alternatives(formats);
}
} // namespace asperity::geometry
