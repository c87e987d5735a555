#pragma once

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace asperity::geometry
{
// An extension in small letters, with its dot, and the reader of files that have it.
template <class Reader>
struct FileFormat
{
  std::string extension;
  Reader read;
};

// In small letters; of a compressed file, NAME.ts.gz, that before .gz.
inline std::string extensionOf(std::string const& file_name)
{
  std::string name = file_name.substr(file_name.find_last_of('/') + 1);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.size() > 3 && name.compare(name.size() - 3, 3, ".gz") == 0) {
    name.resize(name.size() - 3);
  }
  const auto dot = name.find_last_of('.');
  return dot == std::string::npos ? "" : name.substr(dot);
}

// nullptr if none has the extension.
template <class Reader>
Reader const* findFormat(std::vector<FileFormat<Reader>> const& formats,
                         std::string const& file_name)
{
  const auto extension = extensionOf(file_name);
  for (auto const& format : formats) {
    if (format.extension == extension) {
      return &format.read;
    }
  }
  return nullptr;
}

// InputError that lists the extensions if none fits.
template <class Reader>
Reader formatOf(std::vector<FileFormat<Reader>> const& formats, std::string const& file_name,
                std::string const& what)
{
  auto const* found = findFormat(formats, file_name);
  if (found == nullptr) {
    std::vector<std::string> known;
    for (auto const& format : formats) {
      known.push_back(format.extension);
    }
    throw InputError(what + " '" + file_name + "': its extension '" + extensionOf(file_name) +
                     "' is not that of a known format: " + quotedAlternatives(known) + ".");
  }
  return *found;
}
} // namespace asperity::geometry
