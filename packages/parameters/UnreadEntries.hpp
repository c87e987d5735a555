#pragma once

#include "parameters/Parameters.hpp"

#include <string>
#include <vector>

namespace asperity
{
// An entry of a list that a choice has not selected, so that nothing reads it.
struct UnreadEntry
{
  std::string path;   // "Time Stepping / Step Doubling / Tolerance"
  std::string choice; // "Time Stepping / Control"
  std::string word;   // of the choice that reads the entry: "Step Doubling"
  std::string taken;  // the word that the choice has: "Richardson"
};

// The unread entries of a list, given or completed by `valid` (Declare::choiceOfLists); a choice
// that is not given has its default. `path` is where the list stands. InputError if a choice has
// another type or word than declared.
std::vector<UnreadEntry> unreadEntries(ParameterList const& list, ParameterList const& valid,
                                       std::string const& path = "");
} // namespace asperity
