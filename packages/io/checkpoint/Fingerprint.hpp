#pragma once

#include <string>
#include <vector>

namespace asperity::io
{
// What must not change between a run and its restart: a value for each parameter of the deck, and
// in place of the name of a file the checksum of what it holds.
struct Fingerprint
{
  struct Entry
  {
    std::string parameter; // "Asperity / Friction / a"
    std::string value;     // as text, or a checksum
    std::string content;   // what the checksum is of, "mesh file 'body.h5'"; or empty
  };
  std::vector<Entry> entries;
};

// Why `now` is not what `then` was, in one sentence with the parameter: the first difference. Empty
// if they agree; where a content lies does not matter.
std::string difference(Fingerprint const& then, Fingerprint const& now);
} // namespace asperity::io
