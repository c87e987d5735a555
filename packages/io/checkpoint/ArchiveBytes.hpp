#pragma once

#include "io/checkpoint/Archive.hpp"

#include <vector>

namespace asperity::io::detail
{
// Convert an archive to bytes, for a message to another rank, and back.
std::vector<char> toBytes(Archive const& archive);
Archive fromBytes(std::vector<char> const& bytes);
} // namespace asperity::io::detail
