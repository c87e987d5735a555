#pragma once

#include "fem/Material.hpp"
#include "fem/Warning.hpp"

#include <string>
#include <vector>

namespace asperity::dynamics
{
// What a deck says of the body beside its fault and of the stress on it: the smallest and largest
// value at the nodes of the fault, over all ranks.
struct Extremes
{
  double smallest = 0, largest = 0;
};
struct BesideFault
{
  Extremes density;           // [kg/m^3]
  Extremes shear_modulus;     // [Pa]
  Extremes shear_speed;       // c_s [m/s]
  Extremes pressure_speed;    // c_p [m/s]; of no meaning in antiplane motion
  Extremes radiation_damping; // eta [Pa s/m]; zero if waves are computed
  Extremes normal_stress;     // [Pa] at the start
  bool is_antiplane = false;
};

// "Speeds of waves beside the fault: ..." for the log.
std::string describeSpeeds(BesideFault const& values);

// Questions about values in other units than SI: those that neither rock nor a material of analogue
// experiments has (see PlausibleValues.cpp for the bounds and where they come from).
std::vector<Warning> questionValues(BesideFault const& values);
} // namespace asperity::dynamics
