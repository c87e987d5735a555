#pragma once

#include "base/Types.hpp"
#include "io/files/DirectoryLock.hpp"

#include <filesystem>
#include <vector>

namespace asperity::io
{
enum class ExistingResult
{
  refuse,    // InputError if the directory holds the result of a run
  overwrite, // remove the files of the earlier run, and no other file
  keep       // a restart continues it
};

// Makes the directory if there is none, and checks that files can be written there. If this fails,
// if another process has the lock of the directory, if an existing result would be lost, or if the
// run would write through a link that lies there, throws InputError on every rank and leaves every
// existing file untouched. On rank 0 returns the lock, which others may not have as long as the run
// writes. Collective; rank 0 alone touches the disk.
DirectoryLock prepareOutputDirectory(std::filesystem::path const& directory,
                                     ExistingResult existing, Communicator const& comm);

// The existing files in `directory` that a run writes: parameters.xml, run.log, run.jsonl,
// checkpoint.h5, the segments, and the files that the registered outputs name; also links with
// such names, whatever they lead to. Throws InputError if a folder cannot be read.
std::vector<std::filesystem::path> resultFiles(std::filesystem::path const& directory);
} // namespace asperity::io
