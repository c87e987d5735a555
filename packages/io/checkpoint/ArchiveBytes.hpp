#pragma once

#include "io/checkpoint/Archive.hpp"

#include <cstdint>
#include <vector>

namespace asperity::io::detail
{
// An archive as bytes for a message to another rank, and back.
std::vector<char> toBytes(Archive const& archive);
Archive fromBytes(std::vector<char> const& bytes);

// FNV-1a, to notice a damaged file.
std::int64_t checksum(std::vector<char> const& bytes);
} // namespace asperity::io::detail
