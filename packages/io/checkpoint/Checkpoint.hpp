#pragma once

#include "base/Archive.hpp"
#include "base/Types.hpp"
#include "io/checkpoint/Fingerprint.hpp"

#include <filesystem>

namespace asperity::io
{
// Writes the archives of all ranks, and the nodes that each has, into one HDF5 file.
//
// The file is written under a temporary name, synchronised with the disk and renamed, so that there
// is a complete checkpoint at every moment. Collective.
void writeCheckpoint(std::filesystem::path const& file, Archive archive,
                     Fingerprint const& fingerprint, Communicator const& comm,
                     NodeSets const& here = {});

// Returns the archive that this rank has written, bit for bit, if as many ranks wrote the file and
// each had the nodes of `here`. Otherwise the values at nodes are sent to the ranks that have these
// nodes now, and all other values are those of the first rank. Throws the same InputError on every
// rank if the file is missing, damaged or of another format version, or if the fingerprint differs;
// the message names the first difference. Collective.
Archive readCheckpoint(std::filesystem::path const& file, Fingerprint const& fingerprint,
                       Communicator const& comm, NodeSets const& here = {});
} // namespace asperity::io
