#include "io/WriteRule.hpp"

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

Entries<WriteRule::Conditions> WriteRule::entries(Conditions const& defaults, ParameterList& list)
{
  return Entries<Conditions>(defaults, list)
    .integer("Every n Steps", &Conditions::every_n_steps, Range::atLeast(0),
             "A row is written when this number of steps was accepted since the last row; 0 "
             "switches this rule off.")
    .real("Rate Change Factor", &Conditions::rate_change_factor, "-", Range::atLeast(0),
          "A row is written when the peak slip rate has changed by this factor since the last row; "
          "a value of at most 1 switches this rule off.")
    .real("Every Seconds", &Conditions::interval, "s", Range::atLeast(0),
          "A row is written at the first accepted step at or after each multiple of this time; 0 "
          "switches this rule off.")
    .real("Every Seconds of Rupture", &Conditions::interval_of_rupture, "s", Range::atLeast(0),
          "While the peak slip rate is at least the rupture rate, a row is written at the first "
          "accepted step at or after each multiple of this time; 0 switches this rule off.")
    .real("Rupture Rate", &Conditions::rupture_rate, "m/s", Range::positive(),
          "The rule 'Every Seconds of Rupture' applies while the peak slip rate is at least this.")
    .realArray(
      "Times", &Conditions::times, "s", Range::any(),
      "A row is written at each of these times, which no step passes, to within the smallest "
      "step.")
    .hint("Each of these times may need as many additional steps as there are powers of two "
          "between a step and the smallest one; 'Every Seconds' needs none.");
}

void WriteRule::declare(Declare& parameters, int every_n_steps, double rate_change_factor)
{
  Conditions defaults;
  defaults.every_n_steps = every_n_steps;
  defaults.rate_change_factor = rate_change_factor;
  entries(defaults, *parameters.list());
}

WriteRule::WriteRule(Teuchos::ParameterList const& parameters)
{
  ParameterList declared;
  conditions_ = entries({}, declared).read(parameters, parameters.name());
  const double factor = conditions_.rate_change_factor;
  log_rate_change_ = factor > 1 ? std::log(factor) : std::numeric_limits<double>::infinity();
  std::sort(conditions_.times.begin(), conditions_.times.end());
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
  if (conditions_.every_n_steps > 0 && step.step - last_row_.step >= conditions_.every_n_steps) {
    return true;
  }
  const double change = logOfRate(step.peak_slip_rate) - logOfRate(last_row_.peak_slip_rate);
  if (std::abs(change) >= log_rate_change_) {
    return true;
  }
  const bool is_rupturing = step.peak_slip_rate >= conditions_.rupture_rate;
  if (passesMultiple(conditions_.interval, step.time) ||
      (is_rupturing && passesMultiple(conditions_.interval_of_rupture, step.time))) {
    return true;
  }
  auto const& times = conditions_.times;
  const auto next = std::upper_bound(times.begin(), times.end(), last_time_);
  return next != times.end() && *next <= step.time;
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
