#pragma once

#include <filesystem>

namespace asperity::io::detail
{
// "fault.h5" -> "fault.h5.part": the temporary file, in the same folder.
std::filesystem::path temporaryName(std::filesystem::path const& file);

// Waits until the file is on the disk. Throws OutputError if the system reports a failure.
void synchronise(std::filesystem::path const& file);

// Makes the folder of a file if there is none, in a folder that exists. Throws OutputError.
void makeFolderOf(std::filesystem::path const& file);

// Renames the temporary file to `file`: a process that is killed leaves the old or the new file.
void replace(std::filesystem::path const& file);

// The same, but even a machine that stops leaves the old or the new file.
void replaceDurably(std::filesystem::path const& file);
} // namespace asperity::io::detail
