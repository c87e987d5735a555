#pragma once

#include <string>
#include <vector>

namespace asperity::scenario
{
// "friction law 'Truncated'", "state law 'Slip'", "output 'Global'", ...: everything a deck may
// choose that plugins can bring. What is registered twice stands there twice.
std::vector<std::string> registrations();
} // namespace asperity::scenario
