#include "surfaces/files/BinaryFile.hpp"

#include "base/Errors.hpp"

#include <filesystem>

namespace asperity::geometry
{
BinaryFile::BinaryFile(std::string const& file_name, std::string const& what)
    : where_(what + " '" + file_name + "'")
    , stream_(file_name, std::ios::binary)
{
  std::error_code error;
  ASPERITY_REQUIRE(!std::filesystem::is_directory(file_name, error), where_ << " is a folder.");
  ASPERITY_REQUIRE(stream_.is_open(),
                   where_ << " cannot be opened. Is it there, and may you read it?");
  size_ = std::filesystem::file_size(file_name, error);
  std::array<char, 2> magic{};
  stream_.read(magic.data(), magic.size());
  stream_.clear();
  stream_.seekg(0);
  ASPERITY_REQUIRE(magic[0] != '\x1f' || magic[1] != '\x8b',
                   where_ << " is compressed. Unpack it with gunzip.");
}

void BinaryFile::seek(std::uint64_t position)
{
  position_ = position;
  stream_.seekg(static_cast<std::streamoff>(position));
}

void BinaryFile::read(char* bytes, std::uint64_t count)
{
  if (position_ > size_ || count > size_ - position_) {
    fail("the file ends where " + std::to_string(count) + " more bytes are expected: it is cut.");
  }
  stream_.read(bytes, static_cast<std::streamsize>(count));
  if (!stream_) {
    fail("the file cannot be read.");
  }
  position_ += count;
}

void BinaryFile::requireBytes(std::uint64_t count, std::uint64_t bytes_each,
                              std::string const& things) const
{
  const std::uint64_t capacity = position_ < size_ ? (size_ - position_) / bytes_each : 0;
  if (count > capacity) {
    fail("the file names " + std::to_string(count) + " " + things +
         ", but its size allows at most " + std::to_string(capacity) + ": it is cut or damaged.");
  }
}

void BinaryFile::fail(std::string const& message) const
{
  throw InputError(where_ + ", byte " + std::to_string(position_) + ": " + message);
}
} // namespace asperity::geometry
