#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace asperity
{
// FNV-1a, 64 bits (Fowler, Noll, Vo), of the bytes of the values in memory. It detects damage and
// files that were confused, but not forgery.
class Checksum
{
public:
  explicit Checksum(std::uint64_t seed = 0) { add(seed); }

  std::uint64_t value() const { return value_; }

  Checksum& add(long long number) { return bytes(&number, sizeof number); }
  Checksum& add(std::uint64_t number) { return bytes(&number, sizeof number); }
  Checksum& add(int number) { return add(static_cast<long long>(number)); }

  Checksum& add(std::string const& text)
  {
    return add(std::uint64_t(text.size())).bytes(text.data(), text.size());
  }

  // Adds numbers, or arrays of numbers.
  template <class Row>
  Checksum& add(std::vector<Row> const& rows)
  {
    return add(std::uint64_t(rows.size())).bytes(rows.data(), rows.size() * sizeof(Row));
  }
  Checksum& add(std::vector<std::string> const& texts)
  {
    add(std::uint64_t(texts.size()));
    for (auto const& text : texts) {
      add(text);
    }
    return *this;
  }

private:
  Checksum& bytes(void const* data, std::size_t count)
  {
    auto const* byte = static_cast<unsigned char const*>(data);
    for (std::size_t i = 0; i < count; ++i) {
      value_ = (value_ ^ byte[i]) * 0x100000001b3u;
    }
    return *this;
  }

  std::uint64_t value_ = 0xcbf29ce484222325u;
};

// 16 digits.
inline std::string hexadecimal(std::uint64_t checksum)
{
  std::ostringstream text;
  text.fill('0');
  text.width(16);
  text << std::hex << checksum;
  return text.str();
}

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
