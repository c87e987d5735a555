#pragma once

#include <functional>
#include <string>

namespace asperity::mesh::detail
{
// A file that is complete or not there: write(name) writes it under another name and returns true
// if that succeeds; then it is renamed. `where` begins the message of the InputError otherwise.
void writeCompletely(std::string const& file_name, std::string const& where,
                     std::function<bool(std::string const&)> const& write);

// InputError unless a boundary of this name can have a group of its own in a file.
void requireGroupName(std::string const& boundary, std::string const& where);
} // namespace asperity::mesh::detail
