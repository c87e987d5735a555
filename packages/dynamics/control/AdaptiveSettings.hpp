#pragma once

#include "dynamics/DyadicTime.hpp"
#include "dynamics/control/WaveError.hpp"

#include <Teuchos_ParameterList.hpp>

namespace asperity::dynamics
{
struct AdaptiveSettings
{
  double tolerance = 1e-5;
  Norm norm = Norm::root_mean_square;
  int coarsest_level = 0; // of the largest step allowed
  int finest_level = 0;   // of the smallest step allowed
  int first_level = 0;
  WaveScale waves;

  // Of a list with `Tolerance`, `First Step`, declareWaves() and, unless it has none, `Norm`.
  // wave_rate: WaveScale::slip_rate.
  static AdaptiveSettings from(Teuchos::ParameterList const& parameters, DyadicTime const& clock,
                               double wave_rate);
};

// The parameter `Weight of Waves` of a list.
Declare& declareWaves(Declare& list);
} // namespace asperity::dynamics
