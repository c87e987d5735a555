#pragma once

#include "dynamics/coupling/FrictionProblem.hpp"
#include "fem/FaultSurface.hpp"

// b += the gradient of friction at the velocity v, both vectors of owned dofs: with b = Z v before,
// v solves the rate problem with the right side b.
void addFrictionForces(asperity::fem::FaultSurface const& surface,
                       asperity::dynamics::FrictionProblem const& friction,
                       asperity::Vector const& v, asperity::Vector& b);
