#pragma once

#include "base/Types.hpp"
#include "io/checkpoint/Archive.hpp"

#include <filesystem>
#include <string>

namespace asperity::io
{
// Writes the archives of all ranks into one HDF5 file, rank r's values under /rank_<r>.
//
// The file is written under a temporary name, synchronised with the disk and renamed, so that there
// is a complete checkpoint at every moment. `fingerprint` identifies the deck. Collective.
void writeCheckpoint(std::filesystem::path const& file, Archive const& archive,
                     std::string const& fingerprint, Communicator const& comm);

// What this rank has written, bit for bit. InputError, the same on every rank, if the file is
// missing, damaged, of another format version, of another number of ranks or of another deck.
Archive readCheckpoint(std::filesystem::path const& file, std::string const& fingerprint,
                       Communicator const& comm);
} // namespace asperity::io
