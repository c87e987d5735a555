#pragma once

#include "base/Parameters.hpp"
#include "fem/Constraints.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Boundary Conditions`: one list of any name for each condition.
RCP<const ParameterList> boundaryParameters();

struct BoundaryConditions
{
  std::string fault;   // name of the boundary with friction
  std::string surface; // of the first free surface; empty if there is none
  std::vector<fem::VelocityCondition<2>> velocities;
  double ramp_end = 0; // when the last loading ramp has ended [s]
};

// components: 2 in plane strain, 1 antiplane. InputError on contradictions that need no mesh to be
// seen.
BoundaryConditions makeBoundaryConditions(ParameterList const& list, int components);
} // namespace asperity::scenario
