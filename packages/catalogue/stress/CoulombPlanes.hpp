#pragma once

#include "fem/stress/CoulombPlane.hpp"
#include "parameters/Parameters.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// The name of the field of a plane.
inline std::string coulombField(std::string const& plane)
{
  return "coulomb_stress_change_" + plane;
}

// The entry `East` of the deck's list `Output`.
struct DirectionEast
{
  std::vector<double> east = {1, 0, 0}; // as the deck gives it

  static DirectionEast from(ParameterList const& output);
};

// Adds the planes on which outputs may ask for the Coulomb stress change to the deck's list
// `Output`, and the direction east from which strikes count.
void declareCoulombPlanes(Declare& output);

// By name. `output` is the completed list; dimension: of space. Throws InputError for planes whose
// numbers do not fit, and for names that no field can have.
std::map<std::string, fem::CoulombPlane> coulombPlanes(ParameterList const& output, int dimension);

// The planes whose field no output of the completed list selects.
std::vector<std::string> unwrittenPlanes(ParameterList const& output);
} // namespace asperity::catalogue
