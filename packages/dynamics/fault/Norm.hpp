#pragma once

#include <string>
#include <utility>
#include <vector>

namespace asperity::dynamics
{
// How the difference of two fields is measured over the fault.
enum class Norm
{
  root_mean_square,
  maximum
};

// What decks call them, for Entries::choice.
std::vector<std::pair<std::string, Norm>> normWords();
} // namespace asperity::dynamics
