#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::geometry
{
// A text file, compressed by gzip or not, as words line by line; commas separate words, too. All
// functions throw InputError with file, line and what is expected there.
class TextFile
{
public:
  // what: "Surface file", for messages; comment: what follows this character on a line is skipped.
  TextFile(std::string const& file_name, std::string const& what, char comment = '\0');
  ~TextFile();
  TextFile(TextFile const&) = delete;
  TextFile& operator=(TextFile const&) = delete;

  // Goes to the next line that has words; false at the end.
  bool next();
  std::vector<std::string_view> const& words() const { return words_; } // valid until next()
  std::string_view word(std::size_t i) const { return words_[i]; }
  std::string_view line() const { return line_; }
  bool followsBlank() const { return follows_blank_; } // whether a line without words is before it
  std::string_view rest(std::size_t i) const;          // of the line, from word i on

  // form: "VRTX number x y z", for the message if the line has fewer words.
  void require(std::size_t num_words, char const* form) const;
  double number(std::size_t i) const;      // finite
  double numberOrNan(std::size_t i) const; // the same, or the word nan in lower or upper case
  std::int64_t integer(std::size_t i) const;

  [[noreturn]] void fail(std::string const& message) const; // "WHERE, line N: message"
  std::string const& where() const { return where_; }       // "Surface file 'NAME'"
  std::uint64_t size() const { return size_; } // of the file [bytes]; at least of a compressed one
  std::uint64_t offset() const { return offset_; } // of the first byte behind the line

private:
  struct Source;
  bool fill();

  std::string where_;
  char comment_;
  std::unique_ptr<Source> source_;
  std::string buffer_;
  std::size_t begin_ = 0;
  std::uint64_t size_ = 0, offset_ = 0;
  long long line_number_ = 0;
  bool follows_blank_ = false;
  std::string_view line_;
  std::vector<std::string_view> words_;
};
} // namespace asperity::geometry
