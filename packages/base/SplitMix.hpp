#pragma once

#include <cstdint>

namespace asperity
{
// The first number of the splitmix64 sequence that starts at a seed (Steele, Lea, Flood 2014).
// Neighbouring seeds give unrelated numbers.
inline std::uint64_t splitMix(std::uint64_t seed)
{
  auto x = seed + 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}
} // namespace asperity
