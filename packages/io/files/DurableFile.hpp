#pragma once

#include <filesystem>
#include <string>

namespace asperity::io::detail
{
// "fault.h5" -> "fault.h5.part", beside the file that it is to become.
std::filesystem::path temporaryName(std::filesystem::path const& file);

// Waits until the file is on the disk. OutputError if the system says that it cannot be.
void synchronise(std::filesystem::path const& file);

// Gives the temporary file its name: a process that is killed leaves the old or the new file.
void replace(std::filesystem::path const& file);

// The same, and also a machine that stops leaves the old or the new file.
void replaceDurably(std::filesystem::path const& file);

} // namespace asperity::io::detail

namespace asperity::io
{
// Replaces the file, in a folder that is made if there is none, by one of this text.
void replaceText(std::filesystem::path const& file, std::string const& text);
} // namespace asperity::io
