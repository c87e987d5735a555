#pragma once

#include "base/program/Options.hpp"

#include <functional>
#include <list>
#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// The arguments after the name of a command, which declares its options, reads them, and works:
//
//   double width = 1;
//   arguments.number("--width", width, "along x, m");
//   if (arguments.read({"OUT.h5"})) { ... arguments.file(0) ... }
//
// For --help nothing is read. What is not given keeps its value, which --help prints.
class Arguments : public Options
{
public:
  explicit Arguments(std::optional<std::vector<std::string>> words) : words_(std::move(words)) {}

  // double, int, and std::optional of them, which has no value unless the option is given.
  template <class Number>
  Arguments& number(std::string const& name, Number& target, std::string const& meaning);
  void overwrite(); // declares the flag for requireNew

  // Whether the command has to work. `files` are the names that --help uses, such as "OUT.h5".
  // InputError if an option is unknown or no number, or a file is missing; at least `fewest` of
  // them have to be there, all if that is not given.
  bool read(std::vector<std::string> const& files, std::optional<std::size_t> fewest = {});
  int numFiles() const { return static_cast<int>(files_.size()); }
  std::string const& file(int i) const { return files_[static_cast<std::size_t>(i)]; }

  // InputError if the file exists and --overwrite is not given.
  void requireNew(std::string const& file_name) const;

private:
  std::optional<std::vector<std::string>> words_; // none for --help
  std::list<std::string> texts_;                  // a list, because Options keeps references
  std::vector<std::function<void()>> readers_;
  std::vector<std::string> files_;
  bool overwrites_ = false;
};
} // namespace asperity::geometry
