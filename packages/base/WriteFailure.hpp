#pragma once

#include "base/Errors.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <ostream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace asperity
{
// The system's error when a file is opened for writing, 0 if there is none.
inline int errorOfOpening(std::filesystem::path const& path, int flags = 0)
{
  constexpr int private_file = 0600;
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, private_file);
  if (descriptor < 0) {
    return errno;
  }
  ::close(descriptor);
  return 0;
}

// "Is the disk full?", with the limit of the size of files where this process has one.
inline std::string diskFullHint()
{
  rlimit limit{};
  const bool limited = ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? "Is the disk full, or has the file reached the limit of " +
                     std::to_string(limit.rlim_cur) + " bytes for one file (ulimit -f)?"
                 : "Is the disk full?";
}

// A sentence for the end of a message: why a file could not be written. Streams and MPI do not
// report the system's error, so the file is opened once more or, if it does not exist, an unnamed
// file in its folder: "The system says: Read-only file system." If that succeeds, a full disk is
// the most likely cause, or a limit of the size of files. No file is changed.
inline std::string writeFailureReason(std::filesystem::path const& file)
{
  int error = errorOfOpening(file);
  if (error == ENOENT) {
    auto const folder = file.parent_path();
    error = errorOfOpening(folder.empty() ? "." : folder, O_TMPFILE);
  }
  // Not every file system supports unnamed files.
  return error == 0 || error == EOPNOTSUPP
           ? diskFullHint()
           : std::string("The system says: ") + std::strerror(error) + ".";
}

// Throws OutputError unless the file has all that was written to its stream.
inline void requireWritten(std::ostream& stream, std::filesystem::path const& file)
{
  stream.flush();
  if (!stream) {
    throw OutputError(file.string() + " cannot be written. " + writeFailureReason(file));
  }
}
} // namespace asperity
