#pragma once

#include "base/Archive.hpp"
#include "io/checkpoint/Fingerprint.hpp"

namespace asperity::fuzz
{
// What the checkpoints of the corpus belong to.
inline io::Fingerprint sampleFingerprint()
{
  return {{{"Asperity / Friction / a", "0.015", ""},
           {"Asperity / Mesh", "0123456789abcdef", "mesh file 'body.h5'"}}};
}

inline NodeSets sampleNodes() { return {{"body", {0, 1, 2, 5}}, {"fault", {1, 2}}}; }

// A value of each kind.
inline Archive sampleArchive()
{
  Archive archive;
  archive.set("state/time", 1.5);
  archive.set("steps", 12);
  archive.set("name", std::string("wedge"));
  archive.set("history", std::vector<double>{1, 2, 4});
  archive.set("counts", std::vector<std::int64_t>{3, 1});
  archive.setAtNodes("state/u", std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}, "body");
  archive.setAtNodes("state/alpha", std::vector<double>{-8, -7}, "fault");
  archive.setAtNodes("state/flags", std::vector<std::int64_t>{1, 0}, "fault");
  return archive;
}
} // namespace asperity::fuzz
