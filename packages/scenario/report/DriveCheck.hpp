#pragma once

#include "base/Warning.hpp"
#include "scenario/Problem.hpp"

#include <vector>

namespace asperity::scenario
{
// The fastest drive [m/s] that is plausible. No machine that shears rock or analogue materials
// passes some metres per second, and the bodies of quasi-dynamic models, which have no waves,
// follow their boundaries at once: they stand for plates and slow machines.
double fastestDrive(bool is_quasi_dynamic);

// A warning for each condition of the Type Prescribed Velocity, and for each Plate Rate, that is
// faster somewhere at any time. Slip rates that are prescribed are not among them: those of an
// earthquake are as fast. Collective.
template <int Dim>
std::vector<Warning> warnOfDrive(Problem<Dim> const& problem, ParameterList const& deck);
} // namespace asperity::scenario
