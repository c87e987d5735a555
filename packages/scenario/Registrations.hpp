#pragma once

#include <string>
#include <vector>

namespace asperity::scenario
{
// All registered laws, outputs and kinds of fault: "friction law 'Truncated'", "state law
// 'Slip'", "output 'Global'", ... A name that is registered twice occurs twice.
std::vector<std::string> registrations();
} // namespace asperity::scenario
