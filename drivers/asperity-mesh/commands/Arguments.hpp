#pragma once

#include "base/program/Options.hpp"

#include <functional>
#include <list>
#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// The arguments after the name of a command, which declares its options; then they are read:
//
//   double width = 1;
//   arguments.number("--width", width, "along x, m");
//   arguments.read(words, {"OUT.h5"}, 1);
//   ... arguments.file(0) ...
//
// What is not given keeps its value, which --help prints. Targets have to outlive the arguments.
class Arguments : public Options
{
public:
  // double, int, and std::optional of them, which has no value unless the option is given.
  template <class Number>
  Arguments& number(std::string const& name, Number& target, std::string const& meaning);
  void overwrite(); // declares the flag for requireNew

  // Reads options and names of files. `files` are the names that --help uses, such as "OUT.h5".
  // InputError if an option is unknown or no number, a file is missing, of which at least `fewest`
  // have to be there, or there are too many.
  void read(std::vector<std::string> const& words, std::vector<std::string> const& files,
            std::size_t fewest);
  int numFiles() const { return static_cast<int>(files_.size()); }
  std::string const& file(int i) const { return files_[static_cast<std::size_t>(i)]; }

  // InputError if the file exists and --overwrite is not given.
  void requireNew(std::string const& file_name) const;

private:
  std::list<std::string> texts_; // a list, because Options keeps references
  std::vector<std::function<void()>> readers_;
  std::vector<std::string> files_;
  bool overwrites_ = false;
};
} // namespace asperity::geometry
