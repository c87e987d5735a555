#include "io/checkpoint/Fingerprint.hpp"

#include <algorithm>

namespace asperity::io
{
namespace
{
using Entry = Fingerprint::Entry;

std::string shown(Entry const& entry)
{
  return entry.content.empty() ? "'" + entry.value + "'" : entry.content;
}

std::string difference(Entry const& then, Entry const& now)
{
  if (then.parameter != now.parameter) {
    return "where the run had " + then.parameter + " there is now " + now.parameter + ".";
  }
  if (then.content.empty() || now.content.empty()) {
    return now.parameter + " is " + shown(now) + ", and was " + shown(then) + ".";
  }
  return "the content of " + now.content + " (" + now.parameter + ") has changed since then.";
}
} // namespace

std::string difference(Fingerprint const& then, Fingerprint const& now)
{
  const auto agree = [](Entry const& a, Entry const& b) {
    return a.parameter == b.parameter && a.value == b.value &&
           a.content.empty() == b.content.empty();
  };
  const auto [old_entry, new_entry] = std::mismatch(then.entries.begin(), then.entries.end(),
                                                    now.entries.begin(), now.entries.end(), agree);
  const bool was_there = old_entry != then.entries.end();
  const bool is_there = new_entry != now.entries.end();
  if (was_there && is_there) {
    return difference(*old_entry, *new_entry);
  }
  if (was_there) {
    return old_entry->parameter + " is missing, and was " + shown(*old_entry) + ".";
  }
  return is_there ? new_entry->parameter + " is new." : "";
}
} // namespace asperity::io
