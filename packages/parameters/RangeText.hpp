#pragma once

#include "registry/Range.hpp"

#include <string>

namespace asperity
{
// "(0, inf)", "[0, 0.5]"
std::string textOf(Range const& range);
} // namespace asperity
