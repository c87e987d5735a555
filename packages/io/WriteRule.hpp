#pragma once

#include "base/Parameters.hpp"
#include "io/Archive.hpp"
#include "io/Output.hpp"

#include <vector>

namespace asperity::io
{
// Which accepted steps are worth a row: the first and the last one, every nth, those where the peak
// slip rate has changed by a factor since the last row, and the first at or past given times.
class WriteRule
{
public:
  // Adds `Every n Steps`, `Rate Change Factor` and `Times` to an output's parameters.
  static void declare(Declare& parameters, int every_n_steps, double rate_change_factor);

  explicit WriteRule(Teuchos::ParameterList const& parameters);

  // Whether to write a row for this step; if so, it is the last row from now on.
  bool isDue(StepInfo const& step);

  void save(Archive& archive) const;
  void restore(Archive const& archive);

private:
  bool hasReason(StepInfo const& step) const;

  int every_n_steps_;              // 0: not for this reason
  double log_rate_change_;         // infinite: not for this reason
  std::vector<double> times_;      // sorted [s]

  bool has_row_ = false;
  StepInfo last_row_;
  double last_time_ = 0;           // of the last step, row or not [s]
};
} // namespace asperity::io
