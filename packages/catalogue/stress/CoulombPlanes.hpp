#pragma once

#include "fem/stress/CoulombPlane.hpp"
#include "parameters/Parameters.hpp"

#include <map>
#include <string>

namespace asperity::catalogue
{
// Adds the planes on which outputs may ask for the Coulomb stress change to the deck's list
// `Output`, and the direction east from which strikes count.
void declareCoulombPlanes(Declare& output);

// By name. `output` is the completed list; dimension: of space. Throws InputError for planes whose
// numbers do not fit, and for names that no field can have.
std::map<std::string, fem::CoulombPlane> coulombPlanes(ParameterList const& output, int dimension);
} // namespace asperity::catalogue
