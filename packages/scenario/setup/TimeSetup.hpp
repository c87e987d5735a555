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

// Names of its entries that its declaration and its readers share.
namespace time_entries
{
inline constexpr char const* final_time = "Final Time";
inline constexpr char const* scheme = "Scheme";
inline constexpr char const* largest_step = "Largest Step";
inline constexpr char const* smallest_step = "Smallest Step";
} // namespace time_entries

// The entries of the list without those of watches.
struct TimeSettings
{
  double final_time = 0;        // [s]
  std::vector<double> instants; // [s]
  std::string scheme = "Newmark";
  double largest_step = 33554432;      // [s]
  bool names_largest_step = false;     // whether the deck gives it
  std::optional<double> smallest_step; // [s]
  std::string control = "Step Doubling";
  ParameterList scheme_list, control_list; // the lists of the chosen scheme and control
  std::string tolerance_entry;             // of that list; "" if the control has no tolerance
  double tolerance = 0;                    // of the control; 0 if it has none

  static TimeSettings from(ParameterList const& list);
};

// The final time of the run, and the settings' instants and the output times [s] before it, in
// ticks, ascending.
std::vector<dynamics::DyadicTime::Ticks> instants(TimeSettings const& settings,
                                                  std::vector<double> const& output_times,
                                                  dynamics::DyadicTime const& clock);
// The clock whose smallest step [s] is that of the deck, or a given one. Throws InputError where it
// is missing, where the largest step is more than 2^60 times as large, or where the run is longer
// than 4.5e18 of them.
dynamics::DyadicTime makeClock(TimeSettings const& settings);
dynamics::DyadicTime makeClock(TimeSettings const& settings, double smallest);

// What a step control needs of the problem in addition to its step.
struct ControlSetting
{
  double wave_rate = 0;                     // dynamics::WaveScale::slip_rate [m/s]
  RCP<const Vector> displacement;           // at the start of the run; null: zero
  std::array<double, 2> least_motion{};     // below which no error matters [m, m/s]
  std::function<std::string(int)> place_of; // see dynamics::ControlContext
};

// The step control that the deck chooses. No step passes the end of the run, an instant of the
// settings, or an output time [s].
std::unique_ptr<dynamics::StepControl> makeStepControl(TimeSettings const& settings,
                                                       std::vector<double> const& output_times,
                                                       dynamics::CoupledStep& step,
                                                       ControlSetting const& setting = {});
} // namespace asperity::scenario
