#pragma once

#include "dynamics/control/StepControl.hpp"
#include "parameters/Parameters.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Time Stepping`, with the entries of watches, and a sentence about it.
RCP<const ParameterList> timeParameters();
std::string meaningOfTime();

// The entries of this list, without those of its sublists.
struct TimeSettings
{
  double final_time = 0;        // [s]
  std::vector<double> instants; // [s]
  std::string scheme = "Newmark";
  double largest_step = 33554432;      // [s]
  std::optional<double> smallest_step; // [s]
  std::string control = "Step Doubling";

  static TimeSettings from(ParameterList const& list);
};

// The default of `Scheme` for a body without mass.
constexpr char const* massless_scheme = "Generalised Alpha";

// `Tolerance` of the control that the list chooses; 0 if that has none.
double stepTolerance(ParameterList const& list);
// `Final Time`, and those of `Instants` and of the output times [s] that are in the run, in ticks,
// ascending.
std::vector<dynamics::DyadicTime::Ticks> instants(ParameterList const& list,
                                                  std::vector<double> const& output_times,
                                                  dynamics::DyadicTime const& clock);
// With the smallest step [s] of the list, or another one. Throws InputError where it is missing,
// where the largest step is more than 2^60 times as large, or where the run is longer than 4.5e18
// of them.
dynamics::DyadicTime makeClock(ParameterList const& list);
dynamics::DyadicTime makeClock(ParameterList const& list, double smallest);
// Without mass throws InputError for a scheme that damps nothing (Newmark, or generalised alpha
// with spectral radius 1): its velocity would have the amplification factor -1.
dynamics::RateUpdate makeRateUpdate(ParameterList const& list, bool has_mass = true);
// What a step control knows of the problem beside its step.
struct ControlSetting
{
  double wave_rate = 0;                     // dynamics::WaveScale::slip_rate [m/s]
  RCP<const Vector> displacement;           // at the start of the run; null: zero
  std::array<double, 2> least_motion{};     // below which no error matters [m, m/s]
  std::function<std::string(int)> place_of; // see dynamics::ControlContext
};

// No step passes the end of the run, an instant of the list, or an output time [s].
std::unique_ptr<dynamics::StepControl> makeStepControl(ParameterList const& list,
                                                       std::vector<double> const& output_times,
                                                       dynamics::CoupledStep& step,
                                                       ControlSetting const& setting = {});
} // namespace asperity::scenario
