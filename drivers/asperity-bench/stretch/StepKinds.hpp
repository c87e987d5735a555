#pragma once

#include "base/parameters/Parameters.hpp"
#include "scenario/Problem.hpp"

// Steps below this are inertial [s]: the slowest shear wave goes through less than the body's
// longest side in one of them. Zero for a body without mass, whose steps are all quasi-static.
// Collective.
double crossingTime(asperity::ParameterList const& deck,
                    asperity::scenario::Problem<3> const& problem);
