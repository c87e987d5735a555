#include "io/files/DirectoryLock.hpp"

#include "base/Errors.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace asperity::io
{
namespace
{
// "process 4711 on node12"
std::string nameOfThisProcess()
{
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  return "process " + std::to_string(::getpid()) + " on " + host;
}

bool isFileOf(int descriptor, std::filesystem::path const& path)
{
  struct stat opened = {}, named = {};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

// Whether the file is empty or the lock of a run that was killed: it may be overwritten, removed.
bool isLockFile(int descriptor)
{
  const std::string begin = "process ";
  std::string text(begin.size(), '\0');
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink <= 1 &&
         (status.st_size == 0 ||
          (::pread(descriptor, text.data(), text.size(), 0) > 0 && text == begin));
}

[[noreturn]] void refuseFile(std::filesystem::path const& file, std::string const& what)
{
  throw InputError(file.string() + " is " + what +
                   ", not the lock of a run, which would overwrite it. Rename it, or choose "
                   "another directory with --output DIR.");
}
} // namespace

DirectoryLock::DirectoryLock(std::filesystem::path const& directory) : file_(directory / ".lock")
{
  while (!openAndLock()) {
  }
  // For the message of processes that are refused; a failure to write it does no harm.
  const std::string name = nameOfThisProcess() + "\n";
  const bool is_written =
    ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, name.data(), name.size(), 0) > 0;
  static_cast<void>(is_written);
}

// False if the file that was locked is one that its last owner has just removed.
bool DirectoryLock::openAndLock()
{
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0 && errno == ELOOP) {
    refuseFile(file_, "a link");
  }
  if (descriptor_ < 0) {
    throw InputError(
      file_.string() + " cannot be made: " + std::strerror(errno) +
      ". Check the permissions of the output directory and the space on the disk, or "
      "choose another one with --output DIR.");
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(std::exchange(descriptor_, -1));
    std::string other;
    std::getline(std::ifstream(file_), other);
    throw InputError("Another run is writing to " + file_.parent_path().string() +
                     (other.empty() ? "" : " (" + other + ")") +
                     ". Wait for its end, or choose another directory with --output DIR.");
  }
  const bool is_named = isFileOf(descriptor_, file_);
  if (is_named && isLockFile(descriptor_)) {
    return true;
  }
  ::close(std::exchange(descriptor_, -1));
  if (is_named) {
    refuseFile(file_, "another file");
  }
  return false;
}

void DirectoryLock::release()
{
  if (descriptor_ >= 0) {
    if (isFileOf(descriptor_, file_)) {
      ::unlink(file_.c_str());
    }
    ::close(std::exchange(descriptor_, -1));
  }
}

void DirectoryLock::swap(DirectoryLock& other) noexcept
{
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
}
} // namespace asperity::io
