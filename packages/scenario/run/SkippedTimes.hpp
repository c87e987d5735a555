#pragma once

#include "base/Warning.hpp"
#include "parameters/Parameters.hpp"

#include <optional>
#include <vector>

namespace asperity::scenario
{
// Notes steps that pass two times with which expressions of the deck compare t: what those say
// between the two, as a push of ten seconds in a step of a day, is in no step, and no error
// estimate knows of it.
class SkippedTimes
{
public:
  // deck: complete, its names replaced.
  explicit SkippedTimes(ParameterList const& deck);

  // A warning of the first such step, from `begin` to `end` [s].
  std::optional<Warning> note(double begin, double end);

private:
  std::vector<double> times_; // [s], ascending
  bool has_warned_ = false;
};
} // namespace asperity::scenario
