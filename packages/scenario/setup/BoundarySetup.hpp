#pragma once

#include "base/parameters/Parameters.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/constraints/Constraints.hpp"
#include "scenario/setup/fault/PlateRate.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Boundary Conditions`: one list of any name for each condition.
RCP<const ParameterList> boundaryParameters();

template <int Dim>
struct BoundaryConditions
{
  // Boundaries with friction: one, or several faults between two bodies, which have one surface.
  fem::Boundaries faults;
  // Of all of them.
  fem::OtherSide other_side;
  std::vector<PlateRate> plate_rates; // of the faults that have one
  std::string surface;                // of the first free surface; empty if there is none
  std::vector<std::string> absorbing; // boundaries with dashpots
  std::vector<fem::VelocityCondition<Dim>> velocities;
  double ramp_end = 0; // when the last loading ramp has ended [s]
};

// components of the displacement: Dim, or 1 antiplane. InputError on contradictions that need no
// mesh to be seen.
template <int Dim>
BoundaryConditions<Dim> makeBoundaryConditions(ParameterList const& list, int components);
} // namespace asperity::scenario
