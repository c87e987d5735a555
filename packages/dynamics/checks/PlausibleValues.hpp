#pragma once

#include "base/Warning.hpp"
#include "fem/bulk/Material.hpp"

#include <string>
#include <vector>

namespace asperity::dynamics
{
// The smallest and largest value at the nodes of the fault, over all ranks.
struct Extremes
{
  double smallest = 0, largest = 0;
};
// What a deck says about the body next to its fault and about the stress on the fault; without a
// fault, about the whole body alone.
struct BesideFault
{
  Extremes density;           // [kg/m^3]
  Extremes shear_modulus;     // [Pa]
  Extremes shear_speed;       // c_s [m/s]
  Extremes pressure_speed;    // c_p [m/s]; of no meaning in antiplane motion
  Extremes radiation_damping; // eta [Pa s/m]; zero if waves are computed
  Extremes normal_stress;     // [Pa] at the start
  bool is_antiplane = false;
  bool has_fault = true;
};

// The slip rate [m/s] above which strains are not small any more: V sends out a shear wave with the
// strain V / (2 c_s), and rock breaks below 1 %. The bound is c_s / 10, a strain of 5 %, of the
// fastest wave beside the fault.
double largestSlipRate(BesideFault const& values);
Warning warnOfSlipRate(double slip_rate, double largest);

// "Beside the fault shear waves travel at c_s = ...", for the log.
std::string describeSpeeds(BesideFault const& values);

// Warnings about values that neither rock nor a material of analogue experiments has: they are
// probably not in SI units. PlausibleValues.cpp has the bounds and their sources.
std::vector<Warning> warnOfImplausibleValues(BesideFault const& values);
} // namespace asperity::dynamics
