#pragma once

#include <string>
#include <vector>

namespace asperity::scenario
{
// What is registered in all registries of which a deck may use an object (Registrations.cpp lists
// them): "friction law 'Truncated'", "watch 'ring_watch'", "output 'Global'", ... A name that is
// registered twice occurs twice.
std::vector<std::string> registrations();
} // namespace asperity::scenario
