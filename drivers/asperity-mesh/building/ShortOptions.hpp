#pragma once

#include "parameters/Parameters.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::geometry
{
// The options that stand for a deck of `asperity-mesh build`; an empty one was not given.
struct ShortOptions
{
  std::vector<std::string> faults; // NAME=FILE[,KEY=VALUE]...
  std::string ground;              // FILE[,KEY=VALUE]...
  std::string units;               // of all files that name none
  std::string size, largest, growth, margin, depth, snap, projection, deck;
  std::vector<std::string> overlays;    // of that deck
  std::vector<std::string> assignments; // "Path/To/Parameter=value"
};

// Adds to a deck, or replaces in it, what the options say. A key is the name of a parameter in
// small letters with - for blanks; a length may have its unit, as 500m or 20km. folder: that of the
// deck, to which its files are relative; files of options are relative to where the program runs.
// InputError for options of another form.
void applyOptions(ShortOptions const& options, ParameterList& deck,
                  std::filesystem::path const& folder);
} // namespace asperity::geometry
