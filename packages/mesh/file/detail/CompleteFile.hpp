#pragma once

#include <functional>
#include <string>

namespace asperity::mesh::detail
{
// A file that is complete or not there: write(name) writes it under another name; then it is
// renamed. If write throws an OutputError, or the file cannot be renamed, InputError that begins
// with `where` and names the reason, or OutputError if the file could be made but not
// be filled, as on a full disk.
void writeCompletely(std::string const& file_name, std::string const& where,
                     std::function<void(std::string const&)> const& write);

// Throws InputError unless a boundary of this name can have a group of its own in a file.
void requireGroupName(std::string const& boundary, std::string const& where);
} // namespace asperity::mesh::detail
