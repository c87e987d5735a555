#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "io/checkpoint/Fingerprint.hpp"

#include <filesystem>

namespace asperity::io
{
// Writes the archive of the run into one HDF5 file: the values at nodes of all ranks, in the order
// of the nodes' numbers, and all other values as rank 0 has them. `here` has the nodes of the sets
// that the archive names.
//
// The file is written under a temporary name, synchronised with the disk and renamed, so that there
// is a complete checkpoint at every moment. OutputError, on every rank, if the disk refuses.
// Collective.
void writeCheckpoint(std::filesystem::path const& file, Archive const& archive,
                     Fingerprint const& fingerprint, Communicator const& comm,
                     NodeSets const& here = {});

// Returns the archive of this rank, bit for bit what was written, on any number of ranks: the
// values at its own nodes of `here`, and all others, which are those of rank 0. Throws the same
// InputError on every rank if the file is missing, damaged or of another format version, if the
// fingerprint differs (the message names the first difference), or if a set had other nodes.
// Collective.
Archive readCheckpoint(std::filesystem::path const& file, Fingerprint const& fingerprint,
                       Communicator const& comm, NodeSets const& here = {});
} // namespace asperity::io
