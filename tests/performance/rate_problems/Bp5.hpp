#pragma once

#include "dynamics/rate/FrictionProblem.hpp"
#include "scenario/problem/Problem.hpp"

#include <string>
#include <vector>

namespace asperity::performance
{
// xml/bp5_qd.xml with multigrid, with cells of cell_size times 2 km on the fault, and with more
// overrides, "Path/To/Parameter=value".
RCP<ParameterList> bp5(int cell_size, std::vector<std::string> overrides = {});

// b += the gradient of friction at the velocity v, both vectors of owned dofs: with b = Z v before,
// v solves the rate problem with the right side b.
void addFrictionForces(fem::FaultSurface const& surface, dynamics::FrictionProblem const& friction,
                       Vector const& v, Vector& b);
} // namespace asperity::performance
