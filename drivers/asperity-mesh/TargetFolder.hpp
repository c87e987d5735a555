#pragma once

#include <string>

namespace asperity::geometry
{
// InputError if the folder of a file that is to be made is not there or cannot be written to: to be
// asked before the work that leads to the file.
void requireFolder(std::string const& file_name);
} // namespace asperity::geometry
