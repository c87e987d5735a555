#pragma once

#include <functional>
#include <string>

namespace asperity::mesh::detail
{
// Makes a file that is complete if it exists: write(name) writes it under another name, and then it
// is renamed. If write throws an OutputError, or the file cannot be renamed, throws an InputError
// that begins with `where` and contains the reason; or an OutputError if the file could be created
// but not completed, as on a full disk.
void writeCompletely(std::string const& file_name, std::string const& where,
                     std::function<void(std::string const&)> const& write);

// Throws InputError unless a boundary of this name can have a group of its own in a file.
void requireGroupName(std::string const& boundary, std::string const& where);
} // namespace asperity::mesh::detail
