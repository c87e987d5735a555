#pragma once

#include "base/Archive.hpp"
#include "io/Output.hpp"
#include "parameters/Entries.hpp"

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
  struct Conditions
  {
    int every_n_steps = 0;          // 0: rule is off
    double rate_change_factor = 0;  // at most 1: rule is off
    double interval = 0;            // [s], 0: rule is off
    double interval_of_rupture = 0; // likewise, while the peak slip rate is at least rupture_rate
    double rupture_rate = 1e-3;     // [m/s]
    std::vector<double> times = {}; // sorted [s]
  };

  // They join those of the list.
  static Entries<Conditions> entries(Conditions const& defaults, ParameterList& list);
  bool hasReason(StepInfo const& step) const;
  bool passesMultiple(double interval, double time) const;

  Conditions conditions_;
  double log_rate_change_; // infinite: rule is off

  bool has_row_ = false;
  StepInfo last_row_;
  double last_time_ = 0; // of the last step, row or not [s]
};
} // namespace asperity::io
