// Preloaded into a program, lets the n-th operation on files below a folder fail, or kills the
// process in the middle of it. Set in the environment:
//
//   FAULT_FOLDER  absolute path
//   FAULT_AT      n, from 1; 0 only counts
//   FAULT_KIND    kill: SIGKILL, a write has half of its bytes; full: from there on no space to
//                 write, to make a file or folder or to make a file longer, but for run.log, which
//                 has space of its own; readonly: from the n-th write on nothing can be written,
//                 opened for writing, cut, renamed or removed
//   FAULT_ONLY    disturb the n-th operation of this letter, and count these alone: w write,
//                 p pwrite, v writev, q pwritev, s fsync, t ftruncate, r rename; where the disk is
//                 full also o making a file, m making a folder
//   FAULT_RANK    only this rank of mpirun
//   FAULT_COUNT   a file that gets the letter of each operation
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

namespace
{
char const* setting(char const* name)
{
  char const* value = std::getenv(name);
  return value ? value : "";
}

bool isThisRank()
{
  char const* rank = std::getenv("FAULT_RANK");
  char const* mine = std::getenv("OMPI_COMM_WORLD_RANK");
  return !rank || !mine || std::strcmp(rank, mine) == 0;
}

bool isBelow(char const* path)
{
  char const* folder = setting("FAULT_FOLDER");
  return *folder && isThisRank() && std::strncmp(path, folder, std::strlen(folder)) == 0;
}

bool isBelow(int descriptor, bool& is_log)
{
  char link[64], path[PATH_MAX];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = ::readlink(link, path, sizeof path - 1);
  path[size > 0 ? size : 0] = '\0';
  is_log = std::strstr(path, "/run.log") != nullptr;
  return isBelow(path);
}

long& count()
{
  static long number = 0;
  return number;
}

bool hasCome()
{
  const long at = std::atol(setting("FAULT_AT"));
  return at > 0 && count() >= at;
}

// Whether this operation is the one, or after it.
bool isDue(char letter)
{
  char const* only = setting("FAULT_ONLY");
  if (*only && *only != letter) {
    return false;
  }
  ++count();
  if (*setting("FAULT_COUNT")) {
    const auto file =
      ::syscall(SYS_openat, AT_FDCWD, setting("FAULT_COUNT"), O_WRONLY | O_CREAT | O_APPEND, 0666);
    static_cast<void>(::syscall(SYS_write, file, &letter, 1));
    ::close(static_cast<int>(file));
  }
  return hasCome();
}

bool isKind(char const* kind) { return std::strcmp(setting("FAULT_KIND"), kind) == 0; }

bool kills() { return isKind("kill"); }

// Also of a file that is not there yet.
bool isBelowFromHere(char const* path)
{
  char folder[PATH_MAX], whole[2 * PATH_MAX];
  if (*path == '/' || !::getcwd(folder, sizeof folder)) {
    return isBelow(path);
  }
  std::snprintf(whole, sizeof whole, "%s/%s", folder, path);
  return isBelow(whole);
}

// Whether what changes a file, but is no write, fails by now, with errno.
bool isReadOnly(char const* path)
{
  if (!isKind("readonly") || !hasCome() || !isBelowFromHere(path)) {
    return false;
  }
  errno = EROFS;
  return true;
}

bool isReadOnly(int descriptor)
{
  bool is_log = false;
  if (!isKind("readonly") || !hasCome() || !isBelow(descriptor, is_log)) {
    return false;
  }
  errno = EROFS;
  return true;
}

bool isThere(char const* path)
{
  struct stat ignored = {};
  return ::stat(path, &ignored) == 0;
}

// Whether what needs space, but is no write, fails, with errno.
bool hasNoSpace(char letter, char const* path)
{
  if (!isKind("full") || !isBelowFromHere(path) || std::strstr(path, "run.log") || !isDue(letter)) {
    return false;
  }
  errno = ENOSPC;
  return true;
}

bool hasNoSpace(int descriptor, off_t size)
{
  bool is_log = false;
  struct stat before = {};
  if (!isKind("full") || !isBelow(descriptor, is_log) || is_log ||
      ::fstat(descriptor, &before) != 0 || size <= before.st_size || !isDue('t')) {
    return false;
  }
  errno = ENOSPC;
  return true;
}

bool writes(int flags) { return (flags & (O_WRONLY | O_RDWR | O_CREAT | O_TRUNC)) != 0; }

template <class Function>
Function original(char const* name)
{
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

// Calls part() with half of what was to be done and dies, or fails, or calls all().
template <class All, class Part>
ssize_t disturbed(int descriptor, char letter, All const& all, Part const& part)
{
  bool is_log = false;
  if (!isBelow(descriptor, is_log) || (isKind("full") && is_log) || !isDue(letter)) {
    return all();
  }
  if (kills()) {
    part();
    ::kill(::getpid(), SIGKILL);
  }
  errno = isKind("readonly") ? EROFS : ENOSPC;
  return -1;
}

void dieAt(char letter, int descriptor)
{
  bool is_log = false;
  if (kills() && isBelow(descriptor, is_log) && isDue(letter)) {
    ::kill(::getpid(), SIGKILL);
  }
}
} // namespace

extern "C" {
ssize_t write(int file, void const* data, size_t size)
{
  static const auto next = original<ssize_t (*)(int, void const*, size_t)>("write");
  return disturbed(
    file, 'w', [&] { return next(file, data, size); }, [&] { next(file, data, size / 2); });
}

ssize_t pwrite(int file, void const* data, size_t size, off_t place)
{
  static const auto next = original<ssize_t (*)(int, void const*, size_t, off_t)>("pwrite");
  return disturbed(
    file, 'p', [&] { return next(file, data, size, place); },
    [&] { next(file, data, size / 2, place); });
}

ssize_t pwrite64(int file, void const* data, size_t size, off64_t place)
{
  return pwrite(file, data, size, place);
}

ssize_t writev(int file, iovec const* parts, int count)
{
  static const auto next = original<ssize_t (*)(int, iovec const*, int)>("writev");
  return disturbed(
    file, 'v', [&] { return next(file, parts, count); }, [&] { next(file, parts, count / 2); });
}

ssize_t pwritev(int file, iovec const* parts, int count, off_t place)
{
  static const auto next = original<ssize_t (*)(int, iovec const*, int, off_t)>("pwritev");
  return disturbed(
    file, 'q', [&] { return next(file, parts, count, place); },
    [&] { next(file, parts, count / 2, place); });
}

ssize_t pwritev64(int file, iovec const* parts, int count, off64_t place)
{
  return pwritev(file, parts, count, place);
}

int fsync(int file)
{
  static const auto next = original<int (*)(int)>("fsync");
  dieAt('s', file);
  return isReadOnly(file) ? -1 : next(file);
}

int ftruncate(int file, off_t size)
{
  static const auto next = original<int (*)(int, off_t)>("ftruncate");
  dieAt('t', file);
  return isReadOnly(file) || hasNoSpace(file, size) ? -1 : next(file, size);
}

int ftruncate64(int file, off64_t size) { return ftruncate(file, size); }

int rename(char const* from, char const* to)
{
  static const auto next = original<int (*)(char const*, char const*)>("rename");
  if (kills() && isBelowFromHere(from) && isDue('r')) {
    ::kill(::getpid(), SIGKILL);
  }
  return isReadOnly(from) ? -1 : next(from, to);
}

int mkdir(char const* path, mode_t mode)
{
  static const auto next = original<int (*)(char const*, mode_t)>("mkdir");
  return isReadOnly(path) || (!isThere(path) && hasNoSpace('m', path)) ? -1 : next(path, mode);
}

int unlink(char const* path)
{
  static const auto next = original<int (*)(char const*)>("unlink");
  return isReadOnly(path) ? -1 : next(path);
}

int remove(char const* path)
{
  static const auto next = original<int (*)(char const*)>("remove");
  return isReadOnly(path) ? -1 : next(path);
}

int open(char const* path, int flags, ...)
{
  static const auto next = original<int (*)(char const*, int, ...)>("open");
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  const bool makes = (flags & O_CREAT) != 0 && !isThere(path);
  return (writes(flags) && isReadOnly(path)) || (makes && hasNoSpace('o', path))
           ? -1
           : next(path, flags, mode);
}

int open64(char const* path, int flags, ...)
{
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open(path, flags, mode);
}

std::FILE* fopen(char const* path, char const* mode)
{
  static const auto next = original<std::FILE* (*)(char const*, char const*)>("fopen");
  const bool makes = std::strpbrk(mode, "wa") && !isThere(path);
  return (std::strpbrk(mode, "wa+") && isReadOnly(path)) || (makes && hasNoSpace('o', path))
           ? nullptr
           : next(path, mode);
}

std::FILE* fopen64(char const* path, char const* mode) { return fopen(path, mode); }
}
