#pragma once

#include <string>
#include <vector>

namespace asperity::io
{
// The input that must not change between a run and its restart: a value for each parameter of the
// deck, and instead of the name of a file the checksum of its content.
struct Fingerprint
{
  struct Entry
  {
    std::string parameter; // "Asperity / Friction / a"
    std::string value;     // as text, or a checksum
    std::string content;   // source of the checksum, "mesh file 'body.h5'"; or empty
  };
  std::vector<Entry> entries;
};

// One sentence about the first difference between `then` and `now`, with the name of the parameter.
// Empty if they agree. The name of a file does not count, only its content.
std::string difference(Fingerprint const& then, Fingerprint const& now);
} // namespace asperity::io
