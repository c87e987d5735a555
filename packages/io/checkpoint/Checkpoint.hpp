#pragma once

#include "base/Types.hpp"
#include "io/checkpoint/Archive.hpp"
#include "io/checkpoint/Fingerprint.hpp"

#include <filesystem>

namespace asperity::io
{
// Writes the archives of all ranks into one HDF5 file, rank r's values under /rank_<r>.
//
// The file is written under a temporary name, synchronised with the disk and renamed, so that there
// is a complete checkpoint at every moment. Collective.
void writeCheckpoint(std::filesystem::path const& file, Archive const& archive,
                     Fingerprint const& fingerprint, Communicator const& comm);

// Returns the archive that this rank has written, bit for bit. Throws the same InputError on every
// rank if the file is missing, damaged, of another format version or of another number of ranks, or
// if the fingerprint differs; the message names the first difference.
Archive readCheckpoint(std::filesystem::path const& file, Fingerprint const& fingerprint,
                       Communicator const& comm);
} // namespace asperity::io
