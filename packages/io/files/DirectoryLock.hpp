#pragma once

#include <filesystem>

namespace asperity::io
{
// While it lives, no other process has a lock of the same directory. The system ends a lock with
// its process, however that ends, so that no lock is left behind. On a file system without
// locks it has no effect.
class DirectoryLock
{
public:
  DirectoryLock() = default; // of nothing

  // Throws InputError, which names the other process, if there is one that has the lock, and also
  // if the directory cannot be written or has a link or another file in the place of the lock.
  explicit DirectoryLock(std::filesystem::path const& directory);

  ~DirectoryLock() { release(); }
  DirectoryLock(DirectoryLock&& other) noexcept { swap(other); }
  DirectoryLock& operator=(DirectoryLock&& other) noexcept
  {
    swap(other);
    return *this;
  }

private:
  void swap(DirectoryLock& other) noexcept;
  bool openAndLock();
  void release();

  std::filesystem::path file_; // DIR/.lock, which is there as long as the lock
  int descriptor_ = -1;
};
} // namespace asperity::io
