#pragma once

#include "FormatChoice.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <string>

namespace asperity::geometry
{
// A file's name without .gz: a compressed file has the format of what it contains.
std::string uncompressedName(std::string const& file_name);

// The extension of that name in small letters, with its dot; "" if it has none.
std::string extensionOf(std::string const& file_name);

// The registered format of a file of surfaces or grids. what: "Surface file", for messages.
// InputError, which lists the extensions, if none fits.
template <class Format>
Format const& formatOf(std::string const& file_name, std::string const& what)
{
  const auto found = findFormat<Format>(uncompressedName(file_name));
  ASPERITY_REQUIRE(found.format != nullptr, what << " '" << file_name << "': its extension '"
                                                 << extensionOf(file_name)
                                                 << "' is not that of a known format: "
                                                 << quotedAlternatives(endingsOf<Format>())
                                                 << ". A format of your own comes with --plugin.");
  return *found.format;
}
} // namespace asperity::geometry
