#pragma once

#include <cstdint>
#include <functional>
#include <sys/resource.h>

// Calls of libraries that may crash, or use up the memory, when a file is damaged.
namespace asperity::geometry
{
// Whether the work comes to its end: it is tried in a copy of this process (fork), of which nothing
// remains. False if a signal ends the copy, or if it takes more than these seconds of CPU time. An
// exception is an end, too. Work for which the system cannot make a second process is not tried.
// Other threads must not hold locks that the work needs.
bool endsInATrial(std::function<void()> const& work, std::uint64_t seconds);

// While this object lives, the process can take at most this much more memory [bytes]; malloc fails
// beyond.
class MemoryLimit
{
public:
  explicit MemoryLimit(std::uint64_t more);
  ~MemoryLimit();
  MemoryLimit(MemoryLimit const&) = delete;
  MemoryLimit& operator=(MemoryLimit const&) = delete;

private:
  rlimit before_{};
  bool is_set_ = false;
};
} // namespace asperity::geometry
