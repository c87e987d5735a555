#include "surfaces/files/TextFile.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#ifdef ASPERITY_HAVE_ZLIB
#include <zlib.h>
#endif

namespace asperity::geometry
{
namespace
{
constexpr std::size_t block_size = std::size_t(1) << 16;
constexpr std::size_t longest_line = std::size_t(1) << 24; // rows of grids are long

bool isCompressed(std::string const& file_name)
{
  char magic[2] = {};
  std::ifstream(file_name, std::ios::binary).read(magic, 2);
  return magic[0] == '\x1f' && magic[1] == '\x8b';
}

bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == '\v' || c == '\f';
}

template <class Number>
bool readWord(std::string_view word, Number& value)
{
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
  }
  const auto end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && last == end;
}
} // namespace

struct TextFile::Source
{
  std::ifstream plain;
#ifdef ASPERITY_HAVE_ZLIB
  gzFile packed = nullptr;
  ~Source()
  {
    if (packed != nullptr) {
      gzclose(packed);
    }
  }
#endif
};

TextFile::TextFile(std::string const& file_name, std::string const& what, char comment)
    : where_(what + " '" + file_name + "'")
    , comment_(comment)
    , source_(std::make_unique<Source>())
{
  std::error_code error;
  ASPERITY_REQUIRE(!std::filesystem::is_directory(file_name, error), where_ << " is a folder.");
  source_->plain.open(file_name, std::ios::binary);
  ASPERITY_REQUIRE(source_->plain.is_open(),
                   where_ << " cannot be opened. Is it there, and may you read it?");
  size_ = std::filesystem::file_size(file_name, error);
  if (isCompressed(file_name)) {
#ifdef ASPERITY_HAVE_ZLIB
    constexpr std::uint64_t most_expansion = 1032; // of deflate
    size_ *= most_expansion;
    source_->packed = gzopen(file_name.c_str(), "rb");
    ASPERITY_REQUIRE(source_->packed != nullptr, where_ << " cannot be opened.");
#else
    throw InputError(where_ + " is compressed, and this build has no zlib. Unpack it with gunzip.");
#endif
  }
}

TextFile::~TextFile() = default;

// Appends a block to what is left of the buffer; false at the end of the file.
bool TextFile::fill()
{
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t kept = buffer_.size();
  if (kept > longest_line) {
    fail("the line has more than " + std::to_string(longest_line) +
         " characters. Is this a text file?");
  }
  buffer_.resize(kept + block_size);
  std::size_t count = 0;
#ifdef ASPERITY_HAVE_ZLIB
  if (source_->packed != nullptr) {
    const int got =
      gzread(source_->packed, buffer_.data() + kept, static_cast<unsigned>(block_size));
    int error = 0;
    gzerror(source_->packed, &error);
    buffer_.resize(kept + static_cast<std::size_t>(std::max(got, 0)));
    ASPERITY_REQUIRE(got >= 0 && (error == Z_OK || error == Z_STREAM_END),
                     where_ << " cannot be unpacked: it is damaged or cut.");
    return got > 0;
  }
#endif
  source_->plain.read(buffer_.data() + kept, static_cast<std::streamsize>(block_size));
  count = static_cast<std::size_t>(source_->plain.gcount());
  buffer_.resize(kept + count);
  ASPERITY_REQUIRE(!source_->plain.bad(), where_ << " cannot be read.");
  return count > 0;
}

bool TextFile::next()
{
  words_.clear();
  follows_blank_ = false;
  for (; words_.empty(); follows_blank_ = words_.empty() || follows_blank_) {
    std::size_t end = buffer_.find('\n', begin_);
    for (std::size_t searched = buffer_.size() - begin_; end == std::string::npos;) {
      ++line_number_; // of the line that a failure concerns
      const bool more = fill();
      --line_number_;
      if (!more) {
        end = buffer_.size();
        break;
      }
      end = buffer_.find('\n', searched);
      searched = buffer_.size();
    }
    if (begin_ >= buffer_.size()) {
      return false;
    }
    ++line_number_;
    line_ = std::string_view(buffer_).substr(begin_, end - begin_);
    const std::size_t behind = std::min(end + 1, buffer_.size());
    offset_ += behind - begin_;
    begin_ = behind;
    if (comment_ != '\0') {
      line_ = line_.substr(0, line_.find(comment_));
    }
    for (std::size_t i = 0; i < line_.size();) {
      if (isBlank(line_[i])) {
        ++i;
        continue;
      }
      const std::size_t first = i;
      while (i < line_.size() && !isBlank(line_[i])) {
        ++i;
      }
      words_.push_back(line_.substr(first, i - first));
    }
  }
  return true;
}

std::string_view TextFile::rest(std::size_t i) const
{
  if (i >= words_.size()) {
    return {};
  }
  auto const* first = words_[i].data();
  auto const* last = words_.back().data() + words_.back().size();
  return {first, static_cast<std::size_t>(last - first)};
}

void TextFile::require(std::size_t num_words, char const* form) const
{
  if (words_.size() < num_words) {
    fail("it has " + std::to_string(words_.size()) + " words, but '" + form + "' is expected.");
  }
}

double TextFile::number(std::size_t i) const
{
  double value = 0;
  if (i >= words_.size() || !readWord(words_[i], value) || !std::isfinite(value)) {
    fail("a finite number is expected " +
         (i < words_.size() ? "instead of '" + excerpt(std::string(words_[i])) + "'."
                            : "at the end of the line."));
  }
  return value;
}

double TextFile::numberOrNan(std::size_t i) const
{
  const bool is_nan = i < words_.size() && words_[i].size() == 3 &&
                      std::equal(words_[i].begin(), words_[i].end(), "nan", [](char a, char b) {
                        return std::tolower(static_cast<unsigned char>(a)) == b;
                      });
  return is_nan ? std::numeric_limits<double>::quiet_NaN() : number(i);
}

std::int64_t TextFile::integer(std::size_t i) const
{
  std::int64_t value = 0;
  if (i >= words_.size() || !readWord(words_[i], value)) {
    fail("a whole number is expected " +
         (i < words_.size() ? "instead of '" + excerpt(std::string(words_[i])) + "'."
                            : "at the end of the line."));
  }
  return value;
}

void TextFile::fail(std::string const& message) const
{
  throw InputError(where_ + ", line " + std::to_string(line_number_) + ": " + message);
}
} // namespace asperity::geometry
