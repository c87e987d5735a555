#pragma once

#include <filesystem>

namespace asperity::io::detail
{
// "fault.h5" -> "fault.h5.part", beside the file that it is to become.
std::filesystem::path temporaryName(std::filesystem::path const& file);

// Waits until the file is on the disk. InputError if the system says that it cannot be.
void synchronise(std::filesystem::path const& file);

// Synchronises the temporary file, gives it its name, and synchronises the folder: at every moment
// there is either the old or the new file.
void commit(std::filesystem::path const& file);
} // namespace asperity::io::detail
