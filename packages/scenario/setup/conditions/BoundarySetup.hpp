#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/constraints/Constraints.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/conditions/PlateRate.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Boundary Conditions`: one sublist, of any name, for each condition.
RCP<const ParameterList> boundaryParameters();

template <int Dim>
struct BoundaryConditions
{
  // Boundaries with friction: one, or several if the faults lie between two bodies. Several faults
  // form one surface.
  fem::Boundaries faults;
  // The other side of all faults.
  fem::OtherSide other_side;
  std::vector<PlateRate> plate_rates; // of the faults that have one
  std::string surface;                // the first free surface; empty if there is none
  std::vector<std::string> absorbing; // boundaries with dashpots
  std::vector<fem::VelocityCondition<Dim>> velocities;
  double ramp_end = 0; // end of the last loading ramp [s]
};

// components: of the displacement, Dim or, in antiplane models, 1. Throws InputError on
// contradictions that can be found without the mesh.
template <int Dim>
BoundaryConditions<Dim> makeBoundaryConditions(ParameterList const& list, int components);
} // namespace asperity::scenario
