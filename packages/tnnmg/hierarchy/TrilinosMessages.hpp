#pragma once

#include <string>

namespace asperity::tnnmg::detail
{
// Returns, in one line, the part of a long Trilinos error message that helps a user.
std::string usefulPart(std::string const& thrown);
} // namespace asperity::tnnmg::detail
