#pragma once

#include <map>
#include <string>
#include <vector>

// What follows the name of a command: files, options with a value (--cell-size 0.002) and flags
// (--overwrite).
struct Arguments
{
  std::vector<std::string> files;
  std::map<std::string, std::string> options;

  bool has(std::string const& option) const { return options.count(option) > 0; }

  // The value of an option, or `otherwise` if it is not given. InputError unless it is a number, or
  // a whole one.
  double number(std::string const& option, double otherwise) const;
  int integer(std::string const& option, int otherwise) const;
};

struct AllowedArguments
{
  std::vector<std::string> files; // what each is for, as "OUT.h5"
  std::vector<std::string> options;
  std::vector<std::string> flags;
};

// InputError if there are other arguments than these, or not all of the files.
Arguments parseArguments(std::vector<std::string> const& words, AllowedArguments const& allowed);

// InputError if the file is there and --overwrite is not.
void requireNew(std::string const& file_name, Arguments const& arguments);
