#pragma once

#include <string>

namespace asperity
{
// For a message about a file that does not exist: the folder in which it was looked for, if there
// is one, and the file there of the nearest name.
std::string whereNot(std::string const& file_name);
} // namespace asperity
