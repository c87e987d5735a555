#pragma once

#include "dynamics/DyadicTime.hpp"
#include "dynamics/fault/FaultMotion.hpp"

#include <Teuchos_ParameterList.hpp>

namespace asperity::dynamics
{
struct AdaptiveSettings
{
  double tolerance = 1e-5; // of alpha
  Norm norm = Norm::root_mean_square;
  int coarsest_level = 0; // of the largest step allowed
  int finest_level = 0;   // of the smallest step allowed
  int first_level = 0;

  // Of a list with `Tolerance`, `First Step` and, unless it has none, `Norm`.
  static AdaptiveSettings from(Teuchos::ParameterList const& parameters, DyadicTime const& clock);
};
} // namespace asperity::dynamics
