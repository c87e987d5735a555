#pragma once

#include <functional>
#include <string>

namespace asperity::geometry
{
// Prints "asperity-mesh: WARNING: text" on standard error.
void warn(std::string const& text);

// Takes full sentences on what was changed or left out while a file was read.
using RemarkSink = std::function<void(std::string const&)>;
} // namespace asperity::geometry
