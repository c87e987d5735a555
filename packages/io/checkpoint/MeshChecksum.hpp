#pragma once

#include "base/Types.hpp"
#include "mesh/Mesh.hpp"

#include <cstdint>

namespace asperity::io
{
enum class ChecksumOf
{
  numbering, // vertices, cells and facets by their numbers, their regions and boundaries
  everything // and where the vertices are
};

// The checksum of the whole mesh, however it is divided among ranks; the same on every rank.
// Collective.
template <int Dim>
std::uint64_t checksum(Mesh<Dim> const& part, ChecksumOf what, Communicator const& communicator);
} // namespace asperity::io
