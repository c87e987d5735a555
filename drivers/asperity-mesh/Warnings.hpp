#pragma once

#include <functional>
#include <string>

namespace asperity::geometry
{
// Prints "asperity-mesh: WARNING: text" on standard error.
void warn(std::string const& text);

// Gets full sentences about changes and omissions when a file is read.
using RemarkSink = std::function<void(std::string const&)>;
} // namespace asperity::geometry
