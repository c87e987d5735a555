#pragma once

#include "io/Archive.hpp"
#include "io/Output.hpp"
#include "parameters/Parameters.hpp"

#include <vector>

namespace asperity::io
{
// Decides which accepted steps get a row: the first and the last one, every nth, those where the
// peak slip rate has changed by a factor since the last row, the first one at or after each of
// given times (at which the step control ends a step), and the first one at or after each multiple
// of an interval; while the fault ruptures, a second interval applies as well.
class WriteRule
{
public:
  // Adds `Every n Steps`, `Rate Change Factor`, `Every Seconds`, `Every Seconds of Rupture`,
  // `Rupture Rate` and `Times` to an output's parameters.
  static void declare(Declare& parameters, int every_n_steps, double rate_change_factor);

  explicit WriteRule(Teuchos::ParameterList const& parameters);

  // Whether to write a row for this step; if so, the step is remembered as that of the last row.
  bool isDue(StepInfo const& step);

  void save(Archive& archive) const;
  void restore(Archive const& archive);

private:
  bool hasReason(StepInfo const& step) const;
  bool passesMultiple(double interval, double time) const;

  int every_n_steps_;          // 0: rule is off
  double log_rate_change_;     // infinite: rule is off
  double interval_;            // [s], 0: rule is off
  double interval_of_rupture_; // likewise, while the peak slip rate is at least rupture_rate_
  double rupture_rate_;        // [m/s]
  std::vector<double> times_;  // sorted [s]

  bool has_row_ = false;
  StepInfo last_row_;
  double last_time_ = 0; // of the last step, row or not [s]
};
} // namespace asperity::io
