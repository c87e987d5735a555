#pragma once

#include <string>

namespace asperity::geometry
{
// InputError if the folder of a file that is to be made does not exist or cannot be written to.
// Call it before the work that leads to the file.
void requireFolder(std::string const& file_name);
} // namespace asperity::geometry
