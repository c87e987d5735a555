#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <type_traits>

namespace asperity::geometry
{
enum class ByteOrder
{
  little,
  big
};

// The number that stands at `bytes` in this order.
template <class Number>
Number fromBytes(char const* bytes, ByteOrder order)
{
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(Number) <= sizeof(Bits));
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t from = order == ByteOrder::big ? i : sizeof(Number) - 1 - i;
    bits = static_cast<Bits>((bits << 8) | static_cast<unsigned char>(bytes[from]));
  }
  if constexpr (sizeof(Number) == sizeof(Bits)) {
    Number value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  } else {
    return static_cast<Number>(bits);
  }
}

// A binary file that is read from front to back or at given places. A count in a damaged header
// must not lead to memory that the file cannot fill: requireBytes. All functions throw InputError.
class BinaryFile
{
public:
  BinaryFile(std::string const& file_name, std::string const& what); // what: "Surface file"

  std::uint64_t size() const { return size_; } // [bytes]
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position);

  void read(char* bytes, std::uint64_t count);
  template <class Number>
  Number number(ByteOrder order)
  {
    std::array<char, sizeof(Number)> bytes;
    read(bytes.data(), bytes.size());
    return fromBytes<Number>(bytes.data(), order);
  }

  // Unless the rest of the file may hold `count` things of at least `bytes_each` bytes.
  void requireBytes(std::uint64_t count, std::uint64_t bytes_each, std::string const& things) const;

  [[noreturn]] void fail(std::string const& message) const; // "WHERE, byte N: message"
  std::string const& where() const { return where_; }

private:
  std::string where_;
  std::ifstream stream_;
  std::uint64_t size_ = 0, position_ = 0;
};
} // namespace asperity::geometry
