#include "surfaces/FileNames.hpp"

#include <algorithm>
#include <cctype>

namespace asperity::geometry
{
std::string uncompressedName(std::string const& file_name)
{
  const std::string compressed = ".gz";
  return file_name.size() > compressed.size() && hasEnding(file_name, compressed)
           ? file_name.substr(0, file_name.size() - compressed.size())
           : file_name;
}

std::string extensionOf(std::string const& file_name)
{
  std::string name = uncompressedName(file_name.substr(file_name.find_last_of('/') + 1));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto dot = name.find_last_of('.');
  return dot == std::string::npos ? "" : name.substr(dot);
}
} // namespace asperity::geometry
