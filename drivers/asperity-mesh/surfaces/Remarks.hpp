#pragma once

#include <functional>
#include <string>

namespace asperity::geometry
{
// Takes full sentences on what was changed or left out while a file was read.
using RemarkSink = std::function<void(std::string const&)>;

// On the error stream, as warnings of the tool.
void printRemark(std::string const& sentence);
} // namespace asperity::geometry
