#pragma once

#include "commands/Arguments.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// What --help and messages say of a command.
struct CommandText
{
  std::string name;               // "wedge"
  std::string usage;              // the files in --help: "[MODEL.xml] OUT.h5"
  std::string meaning;            // one sentence or two
  std::vector<std::string> files; // the same in messages about a missing file, in their order
  std::optional<std::size_t> fewest_files = {}; // all of them, unless this is given
};

// A command of asperity-mesh. Values of its options are its members, which it declares for --help
// and for a run alike.
class Command
{
public:
  Command() = default;
  virtual ~Command() = default;
  Command(Command const&) = delete;
  Command& operator=(Command const&) = delete;

  virtual CommandText text() const = 0;
  virtual void declareOptions(Arguments& arguments) = 0;
  // Called once, after options and files have been read. InputError if an argument, or a file that
  // it names, is wrong.
  virtual void run(Arguments const& arguments) = 0;
};
} // namespace asperity::geometry
