#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity::test
{
// What the host does with a large view from one place in the code.
struct HostAccess
{
  std::string view;               // its label
  std::size_t bytes = 0;          // of the view, or of the copy
  bool is_copy = false;           // a deep copy from or to memory of the host
  std::int64_t count = 0;         // how often
  std::string work;               // asperity::currentWork()
  std::vector<std::string> stack; // innermost first
};

// Notes of accesses, in memory that the handler of a signal may use.
class AccessNotes
{
public:
  void clear();
  // own_frames: of the stack above this call, which are not noted.
  void add(char const* view, std::size_t bytes, bool is_copy, int own_frames);
  std::vector<HostAccess> all() const;

private:
  struct Note
  {
    std::array<char, 128> view = {};
    std::size_t bytes = 0;
    bool is_copy = false;
    std::int64_t count = 0;
    char const* work = nullptr;
    std::array<void*, 40> frames = {};
    int depth = 0;
  };
  static HostAccess readable(Note const& note);

  std::array<Note, 512> notes_; // more places end the program
  std::size_t size_ = 0;
};
} // namespace asperity::test
