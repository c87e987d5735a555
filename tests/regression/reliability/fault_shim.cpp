// Preloaded into a program, lets the n-th operation on files below a folder fail, or kills the
// process in the middle of it. Set in the environment:
//
//   FAULT_FOLDER  absolute path
//   FAULT_AT      n, from 1; 0 only counts
//   FAULT_KIND    kill: SIGKILL, a write has half of its bytes; full: no space from there on, but
//                 for run.log, which has space of its own
//   FAULT_RANK    only this rank of mpirun
//   FAULT_COUNT   a file that gets a byte for each operation
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
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

// Whether this operation is the one, or after it.
bool isDue()
{
  static long count = 0;
  const long at = std::atol(setting("FAULT_AT"));
  ++count;
  if (*setting("FAULT_COUNT")) {
    const int file = ::open(setting("FAULT_COUNT"), O_WRONLY | O_CREAT | O_APPEND, 0666);
    static_cast<void>(::syscall(SYS_write, file, ".", 1));
    ::close(file);
  }
  return at > 0 && count >= at;
}

bool kills() { return std::strcmp(setting("FAULT_KIND"), "kill") == 0; }

template <class Function>
Function original(char const* name)
{
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

// Calls part() with half of what was to be done and dies, or fails, or calls all().
template <class All, class Part>
ssize_t disturbed(int descriptor, All const& all, Part const& part)
{
  bool is_log = false;
  if (!isBelow(descriptor, is_log) || (!kills() && is_log) || !isDue()) {
    return all();
  }
  if (kills()) {
    part();
    ::kill(::getpid(), SIGKILL);
  }
  errno = ENOSPC;
  return -1;
}
} // namespace

extern "C" {
ssize_t write(int file, void const* data, size_t size)
{
  static const auto next = original<ssize_t (*)(int, void const*, size_t)>("write");
  return disturbed(
    file, [&] { return next(file, data, size); }, [&] { next(file, data, size / 2); });
}

ssize_t pwrite(int file, void const* data, size_t size, off_t place)
{
  static const auto next = original<ssize_t (*)(int, void const*, size_t, off_t)>("pwrite");
  return disturbed(
    file, [&] { return next(file, data, size, place); },
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
    file, [&] { return next(file, parts, count); }, [&] { next(file, parts, count / 2); });
}

ssize_t pwritev(int file, iovec const* parts, int count, off_t place)
{
  static const auto next = original<ssize_t (*)(int, iovec const*, int, off_t)>("pwritev");
  return disturbed(
    file, [&] { return next(file, parts, count, place); },
    [&] { next(file, parts, count / 2, place); });
}

ssize_t pwritev64(int file, iovec const* parts, int count, off64_t place)
{
  return pwritev(file, parts, count, place);
}

int fsync(int file)
{
  static const auto next = original<int (*)(int)>("fsync");
  bool is_log = false;
  if (kills() && isBelow(file, is_log) && isDue()) {
    ::kill(::getpid(), SIGKILL);
  }
  return next(file);
}

int rename(char const* from, char const* to)
{
  static const auto next = original<int (*)(char const*, char const*)>("rename");
  char path[PATH_MAX];
  if (kills() && ::realpath(from, path) && isBelow(path) && isDue()) {
    ::kill(::getpid(), SIGKILL);
  }
  return next(from, to);
}
}
