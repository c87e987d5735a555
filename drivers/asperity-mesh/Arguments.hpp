#pragma once

#include <map>
#include <string>
#include <vector>

// The arguments after the name of a command: files, options with a value (--cell-size 0.002) and
// flags (--overwrite).
struct Arguments
{
  std::vector<std::string> files;
  std::map<std::string, std::string> options;

  std::map<std::string, std::vector<std::string>> repeated;

  bool has(std::string const& option) const { return options.count(option) > 0; }

  // The value of an option, or `otherwise` if it is not given. InputError if it is not a number, or
  // not a whole number.
  double number(std::string const& option, double otherwise) const;
  int integer(std::string const& option, int otherwise) const;

  // The values of an option that may be repeated, in their order.
  std::vector<std::string> all(std::string const& option) const;
};

struct AllowedArguments
{
  std::vector<std::string> files; // the names that --help uses, such as "OUT.h5"
  std::vector<std::string> options;
  std::vector<std::string> flags;
  std::vector<std::string> repeated = {}; // options that may be given several times
};

// InputError if an argument is not among these, or a file is missing.
Arguments parseArguments(std::vector<std::string> const& words, AllowedArguments const& allowed);

// InputError if the file exists and --overwrite is not given.
void requireNew(std::string const& file_name, Arguments const& arguments);
