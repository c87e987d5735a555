#include "surfaces/netcdf/UntrustedWork.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace asperity::geometry
{
namespace
{
// Turns off core files and the output of a library that crashes.
void prepareForCrash(rlim_t seconds)
{
  const rlimit no_core = {0, 0}, time = {seconds, seconds};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::setrlimit(RLIMIT_CPU, &time);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}
} // namespace

bool endsInATrial(std::function<void()> const& work, std::uint64_t seconds)
{
  const pid_t trial = ::fork();
  if (trial < 0) {
    return true;
  }
  if (trial == 0) {
    prepareForCrash(seconds);
    try {
      work();
    } catch (...) { // the caller meets the same error
    }
    ::_exit(0); // without what other parts of the program do at its end
  }
  int status = 0;
  while (::waitpid(trial, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

MemoryLimit::MemoryLimit(std::uint64_t more)
{
  std::uint64_t pages = 0; // of the whole process
  if (!(std::ifstream("/proc/self/statm") >> pages) || ::getrlimit(RLIMIT_AS, &before_) != 0) {
    return;
  }
  auto limit = before_;
  const rlim_t wanted = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + more;
  limit.rlim_cur = std::min(before_.rlim_cur, wanted);
  is_set_ = ::setrlimit(RLIMIT_AS, &limit) == 0;
}

MemoryLimit::~MemoryLimit()
{
  if (is_set_) {
    ::setrlimit(RLIMIT_AS, &before_);
  }
}
} // namespace asperity::geometry
