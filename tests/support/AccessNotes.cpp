#include "support/AccessNotes.hpp"

#include "base/program/WorkTimers.hpp"

#include <cxxabi.h>
#include <execinfo.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace asperity::test
{
namespace
{
// From library(function+0x12) [0x34], as backtrace_symbols writes it, the function's name in C++.
std::string functionOf(std::string const& symbol)
{
  const auto begin = symbol.find('('), end = symbol.find('+', begin);
  if (begin == std::string::npos || end == std::string::npos) {
    return symbol;
  }
  int status = 0;
  auto const mangled = symbol.substr(begin + 1, end - begin - 1);
  char* const name = abi::__cxa_demangle(mangled.c_str(), nullptr, nullptr, &status);
  const std::string result = status == 0 ? name : symbol;
  std::free(name);
  return result;
}
} // namespace

void AccessNotes::clear()
{
  size_ = 0;
  std::array<void*, 1> frame;
  backtrace(frame.data(), 1); // loads what it needs, which a handler must not
}

void AccessNotes::add(char const* view, std::size_t bytes, bool is_copy, int own_frames)
{
  Note note;
  std::strncpy(note.view.data(), view, note.view.size() - 1);
  note.bytes = bytes;
  note.is_copy = is_copy;
  note.count = 1;
  note.work = currentWork();
  std::array<void*, 44> frames;
  const int own = own_frames + 1;
  const int found = backtrace(frames.data(), static_cast<int>(frames.size())) - own;
  note.depth = std::clamp(found, 0, static_cast<int>(note.frames.size()));
  std::copy_n(frames.begin() + own, note.depth, note.frames.begin());

  auto const end = notes_.begin() + static_cast<std::ptrdiff_t>(size_);
  auto const same = std::find_if(notes_.begin(), end, [&](Note const& other) {
    return other.frames == note.frames && other.view == note.view;
  });
  if (same != end) {
    ++same->count;
  } else if (size_ < notes_.size()) {
    notes_[size_++] = note;
  } else {
    std::abort(); // rather than to lose one
  }
}

std::vector<HostAccess> AccessNotes::all() const
{
  std::vector<HostAccess> result;
  std::transform(notes_.begin(), notes_.begin() + static_cast<std::ptrdiff_t>(size_),
                 std::back_inserter(result), readable);
  return result;
}

HostAccess AccessNotes::readable(Note const& note)
{
  HostAccess access{note.view.data(), note.bytes, note.is_copy, note.count, note.work, {}};
  char** const symbols = backtrace_symbols(note.frames.data(), note.depth);
  for (int k = 0; k < note.depth; ++k) {
    access.stack.push_back(functionOf(symbols[k]));
  }
  std::free(symbols);
  return access;
}
} // namespace asperity::test
