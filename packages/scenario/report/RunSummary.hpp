#pragma once

#include "base/Warning.hpp"
#include "dynamics/coupling/CoupledStep.hpp"
#include "dynamics/observables/EnergyBalance.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace asperity::scenario
{
// What the end of the log says of a run.
struct RunSummary
{
  bool finished = false;
  int dimension = 2; // of space
  double time = 0;   // the time reached [s]
  std::int64_t num_steps = 0;
  std::int64_t forced_steps = 0; // accepted although the smallest step did not meet the tolerance
  dynamics::SolveCount count;
  std::string floor_report; // the line of FloorCount::report, or nothing
  std::string watch_report; // the lines of dynamics::Watches::report
  dynamics::Energy energy;
  int setups = 0;
  double setup_seconds = 0;
  std::string directory;
};

// A warning if the defect of the balance of energy exceeds both a thousandth of the largest work or
// of the kinetic energy, and the rounding, 1e-9 of kinetic and elastic energy.
std::optional<Warning> warnOfDefect(dynamics::Energy const& energy);

// The closing paragraphs: the report of the outputs, the effort and the energy.
std::string summarise(RunSummary const& summary, std::string const& output_report);
} // namespace asperity::scenario
