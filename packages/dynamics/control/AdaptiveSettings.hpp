#pragma once

#include "dynamics/DyadicTime.hpp"
#include "dynamics/control/WaveError.hpp"
#include "parameters/Entries.hpp"

namespace asperity::dynamics
{
struct AdaptiveSettings
{
  double tolerance = 1e-5;
  Norm norm = Norm::root_mean_square;
  double first_step = 0;  // [s]; 0: the smallest step
  int coarsest_level = 0; // of the largest step allowed
  int finest_level = 0;   // of the smallest step allowed
  int first_level = 0;
  // Chosen: with a tolerance of 1e-5 tests/verification/layer has its onsets to 0.1 %, and with
  // 1e-3 xml/tpv101_2d.xml needs no largest step.
  WaveScale waves = {0, 0.1};

  // Sets the levels, by the clock and the first step. wave_rate: WaveScale::slip_rate.
  void setLevels(DyadicTime const& clock, double wave_rate);
};

// Adds `Weight of Waves` and `First Step`, which have this meaning.
Entries<AdaptiveSettings>& addCommonEntries(Entries<AdaptiveSettings>& entries,
                                            std::string const& meaning_of_first_step);
} // namespace asperity::dynamics
