#include "io/WriteRule.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::io
{
namespace
{
// A fault at rest has no logarithm of its slip rate.
double logOfRate(double rate)
{
  return std::log(std::max(rate, std::numeric_limits<double>::min()));
}
} // namespace

void WriteRule::declare(Declare& parameters, int every_n_steps, double rate_change_factor)
{
  parameters
    .integer("Every n Steps", every_n_steps, Range::atLeast(0),
             "A row is written when this number of steps was accepted since the last row; 0 "
             "switches this rule off.")
    .real("Rate Change Factor", rate_change_factor, "-", Range::atLeast(0),
          "A row is written when the peak slip rate has changed by this factor since the last row; "
          "a value of at most 1 switches this rule off.")
    .real("Every Seconds", 0.0, "s", Range::atLeast(0),
          "A row is written at the first accepted step at or after each multiple of this time; 0 "
          "switches this rule off.")
    .real("Every Seconds of Rupture", 0.0, "s", Range::atLeast(0),
          "While the peak slip rate is at least the rupture rate, a row is written at the first "
          "accepted step at or after each multiple of this time; 0 switches this rule off.")
    .real("Rupture Rate", 1e-3, "m/s", Range::positive(),
          "The rule 'Every Seconds of Rupture' applies while the peak slip rate is at least this.")
    .realArray(
      "Times", std::vector<double>{}, "s", Range::any(),
      "A row is written at each of these times, which no step passes, to within the smallest "
      "step.")
    .hint("Each of these times may need as many additional steps as there are powers of two "
          "between a step and the smallest one; 'Every Seconds' needs none.");
}

WriteRule::WriteRule(Teuchos::ParameterList const& parameters)
    : every_n_steps_(parameters.get<int>("Every n Steps"))
    , interval_(parameters.get<double>("Every Seconds"))
    , interval_of_rupture_(parameters.get<double>("Every Seconds of Rupture"))
    , rupture_rate_(parameters.get<double>("Rupture Rate"))
{
  const double factor = parameters.get<double>("Rate Change Factor");
  log_rate_change_ = factor > 1 ? std::log(factor) : std::numeric_limits<double>::infinity();
  times_ = parameters.get<Teuchos::Array<double>>("Times").toVector();
  std::sort(times_.begin(), times_.end());
}

bool WriteRule::isDue(StepInfo const& step)
{
  const bool is_due = hasReason(step);
  if (is_due) {
    has_row_ = true;
    last_row_ = step;
  }
  last_time_ = step.time;
  return is_due;
}

bool WriteRule::hasReason(StepInfo const& step) const
{
  if (!has_row_ || step.is_last) {
    return true;
  }
  if (every_n_steps_ > 0 && step.step - last_row_.step >= every_n_steps_) {
    return true;
  }
  const double change = logOfRate(step.peak_slip_rate) - logOfRate(last_row_.peak_slip_rate);
  if (std::abs(change) >= log_rate_change_) {
    return true;
  }
  const bool is_rupturing = step.peak_slip_rate >= rupture_rate_;
  if (passesMultiple(interval_, step.time) ||
      (is_rupturing && passesMultiple(interval_of_rupture_, step.time))) {
    return true;
  }
  const auto next = std::upper_bound(times_.begin(), times_.end(), last_time_);
  return next != times_.end() && *next <= step.time;
}

// Whether a multiple of the interval lies in (last_time_, time].
bool WriteRule::passesMultiple(double interval, double time) const
{
  return interval > 0 && std::floor(time / interval) > std::floor(last_time_ / interval);
}

void WriteRule::save(Archive& archive) const
{
  archive.set("has_row", has_row_);
  archive.set("last_row/step", last_row_.step);
  archive.set("last_row/peak_slip_rate", last_row_.peak_slip_rate);
  archive.set("last_time", last_time_);
}

void WriteRule::restore(Archive const& archive)
{
  has_row_ = archive.getInteger("has_row") != 0;
  last_row_.step = archive.getInteger("last_row/step");
  last_row_.peak_slip_rate = archive.getDouble("last_row/peak_slip_rate");
  last_time_ = archive.getDouble("last_time");
}
} // namespace asperity::io
