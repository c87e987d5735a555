#include "scenario/setup/TimeSetup.hpp"

#include "dynamics/control/StepControlKind.hpp"
#include "dynamics/watches/Watch.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/TimeSchemes.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
// To three digits; value > 0.
double roundedDown(double value)
{
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::floor(value / unit) * unit;
}

void addEntriesOfWatches(Declare& declare)
{
  auto& list = *declare.list();
  auto const& watches = dynamics::WatchRegistry::instance();
  for (auto const& name : watches.names()) {
    auto const added = watches.at(name).validParameters();
    for (auto const& item : *added) {
      auto const& entry = item.first;
      ASPERITY_REQUIRE(!list.isParameter(entry),
                       joinPath(time_path, entry)
                         << " exists already; the watch '" << name
                         << "' of a plugin adds it again. Give it another name there.");
      list.setEntry(entry, item.second);
    }
  }
}

Entries<TimeSettings> timeEntries()
{
  using S = TimeSettings;
  std::vector<Declare::NamedList> controls;
  std::string meaning = "Selects how step sizes are chosen.";
  auto const& registered = dynamics::StepControlRegistry::instance();
  for (auto const& name : registered.names()) {
    auto const& control = registered.at(name);
    controls.emplace_back(name, control.validParameters());
    meaning += ' ' + name + ": " + control.meaning();
  }
  std::vector<Declare::NamedList> schemes;
  std::string meaning_of_schemes =
    "Selects the scheme by which displacement and acceleration follow from the velocity.";
  for (auto const& scheme : timeSchemes()) {
    schemes.emplace_back(scheme.name, scheme.entries);
    meaning_of_schemes += ' ' + scheme.name + ": " + scheme.meaning;
  }
  Entries<S> entries;
  entries
    .real(time_entries::final_time, &S::final_time, required, "s", Range::positive(),
          "The run ends at this time, rounded up to a multiple of the smallest step; the last "
          "steps are cut short to meet it.")
    .realArray("Instants", &S::instants, "s", Range::positive(),
               "No step passes one of these times: a step ends there, to within the smallest step.")
    .hint("Name the times at which a load changes faster than steps follow.")
    .choiceOfLists(time_entries::scheme, &S::scheme, schemes, meaning_of_schemes);
  addEntriesOfWatches(entries.others());
  entries
    .real(time_entries::largest_step, &S::largest_step, "s", Range::positive(),
          "The size of every step is this one divided by a power of two. The default is 2^25 s, "
          "about a year; where steps are prescribed, give it.")
    .real(
      time_entries::smallest_step, &S::smallest_step, optional, "s", Range::positive(),
      "No step is smaller than this, rounded down to the largest step divided by a power of two. "
      "Without it this is a hundredth of L over a seismic slip rate 20 b sigma_n / Z, where Z is "
      "the shear impedance at the fault, and with inertia at most a tenth of the time that a shear "
      "wave takes through a cell at the fault. Where friction has a state but weakens nowhere, a "
      ">= b, there is no default.")
    .hint("Steps that are too large to follow an earthquake lose it: choose it a few hundred times "
          "smaller than L over the slip rate of earthquakes.")
    .choiceOfLists("Control", &S::control, controls, meaning);
  return entries;
}
} // namespace

RCP<const ParameterList> timeParameters() { return timeEntries().list(); }

std::string meaningOfTime()
{
  std::string text =
    "This list selects the time scheme and how the sizes of steps are chosen. Each "
    "step is checked, and the run warns of";
  auto const& watches = dynamics::WatchRegistry::instance();
  char const* separator = " ";
  for (auto const& name : watches.names()) {
    text += separator + watches.at(name).meaning();
    separator = "; ";
  }
  return text + '.';
}

TimeSettings TimeSettings::from(ParameterList const& list)
{
  auto settings = timeEntries().read(list, time_path);
  settings.names_largest_step = !list.getEntry(time_entries::largest_step).isDefault();
  settings.scheme_list = list.sublist(settings.scheme);
  settings.control_list = list.sublist(settings.control);
  settings.tolerance_entry =
    dynamics::StepControlRegistry::instance().at(settings.control).toleranceEntry();
  if (!settings.tolerance_entry.empty()) {
    settings.tolerance = settings.control_list.get<double>(settings.tolerance_entry);
  }
  return settings;
}

std::vector<dynamics::DyadicTime::Ticks> instants(TimeSettings const& settings,
                                                  std::vector<double> const& output_times,
                                                  dynamics::DyadicTime const& clock)
{
  auto times = settings.instants;
  times.insert(times.end(), output_times.begin(), output_times.end());
  std::vector<dynamics::DyadicTime::Ticks> result = {clock.reaching(settings.final_time)};
  for (const double t : times) {
    if (t > 0 && t < settings.final_time) {
      result.push_back(clock.reaching(t));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

dynamics::DyadicTime makeClock(TimeSettings const& settings)
{
  auto const given = settings.smallest_step;
  ASPERITY_REQUIRE(given, time_path << " / " << time_entries::smallest_step
                                    << " is missing: it has no default here. Give it.");
  return makeClock(settings, *given);
}

dynamics::DyadicTime makeClock(TimeSettings const& settings, double smallest)
{
  const double largest = settings.largest_step;
  ASPERITY_REQUIRE(smallest <= largest,
                   time_path << " / " << time_entries::smallest_step << " = " << smallest
                             << " s is larger than the largest step, " << largest << " s.");
  // As a difference, which does not overflow.
  const double levels = std::ceil(std::log2(largest) - std::log2(smallest) - 1e-9);
  const bool is_given = settings.smallest_step.has_value();
  ASPERITY_REQUIRE(levels <= 60 || !is_given,
                   time_path << " / " << time_entries::smallest_step << " = " << smallest
                             << " s is less than the largest one, " << largest
                             << " s, divided by 2^60. Choose a larger 'Smallest Step' or a smaller "
                                "'Largest Step'.");
  ASPERITY_REQUIRE(levels <= 60, time_path << " / " << time_entries::largest_step << " = "
                                           << largest
                                           << " s is more than 2^60 times the smallest step that "
                                              "an earthquake needs, "
                                           << smallest << " s. Choose a smaller one.");
  const dynamics::DyadicTime clock(largest, static_cast<int>(levels));
  // Sums of two times must not overflow.
  constexpr double most_ticks = 4.5e18;
  const double tick = clock.stepSize(clock.finestLevel());
  ASPERITY_REQUIRE(clock.reaches(2 * (settings.final_time + largest)),
                   time_path << " / " << time_entries::final_time << " = " << settings.final_time
                             << " s is too long: time is counted in smallest steps, here of "
                             << tick << " s, to " << most_ticks << " of them. Choose at most "
                             << roundedDown(most_ticks * tick - largest) << " s"
                             << (is_given ? ", or a larger 'Smallest Step'." : ".")
                             << " 'Output / Event Catalogue / Most Events' ends a run earlier.");
  return clock;
}

std::unique_ptr<dynamics::StepControl> makeStepControl(TimeSettings const& settings,
                                                       std::vector<double> const& output_times,
                                                       dynamics::CoupledStep& step,
                                                       ControlSetting const& setting)
{
  auto control = dynamics::StepControlRegistry::instance()
                   .at(settings.control)
                   .make(settings.control_list,
                         {step, step.update().order, time_path, setting.wave_rate,
                          instants(settings, output_times, step.clock()), setting.displacement,
                          setting.least_motion[0], setting.least_motion[1], setting.place_of});
  ASPERITY_REQUIRE(control->adapts() || settings.names_largest_step,
                   time_path << " / " << time_entries::largest_step
                             << " is missing: prescribed steps need it.");
  return control;
}
} // namespace asperity::scenario
