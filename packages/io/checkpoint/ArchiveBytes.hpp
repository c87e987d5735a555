#pragma once

#include "io/checkpoint/Archive.hpp"

#include <vector>

namespace asperity::io::detail
{
// An archive as bytes for a message to another rank, and back.
std::vector<char> toBytes(Archive const& archive);
Archive fromBytes(std::vector<char> const& bytes);
} // namespace asperity::io::detail
