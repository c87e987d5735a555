#include "dynamics/checks/PlausibleValues.hpp"

#include "base/Text.hpp"

namespace asperity::dynamics
{
namespace
{
struct PlausibleRange
{
  double from, to;
};

// The bounds lie a factor of about 3 beyond what has been measured.
//
// Density: foam rubber, in which Brune (1973) made stick slip, has about 30 kg/m^3; steel 7850.
constexpr PlausibleRange densities = {10, 25e3};
// Shear modulus: gelatine of analogue subduction zones (Corbi et al. 2013) has about 1 kPa, the
// lower mantle (PREM, Dziewonski & Anderson 1981) 290 GPa.
constexpr PlausibleRange shear_moduli = {300, 1e12};
// c_s: gelatine 1 to 10 m/s; the lower mantle 7.3 km/s.
constexpr PlausibleRange shear_speeds = {0.3, 22e3};
// The slowest sediments, clay and silt at the sea floor, have 10 m/s (Osler and Chapman 1996) and
// more than 1300 kg/m^3; gels have 1100 kg/m^3. A material that is denser than gels and slower than
// 5 m/s is neither: rock whose modulus is given in MPa has 3 m/s. So the bound lies between these
// two speeds.
constexpr double density_of_sediment = 1300;
constexpr double speed_of_sediment = 5;
// Normal stress over shear modulus: from 3e-6 on creeping faults with nearly lithostatic pore
// pressure (0.1 MPa over 30 GPa) to 0.1 in blocks of gel that bear their own weight (Corbi et al.
// 2013).
constexpr PlausibleRange stress_ratios = {1e-7, 0.3};

// One number where both look the same.
std::string interval(Extremes const& values)
{
  const std::string from = formatShort(values.smallest), to = formatShort(values.largest);
  return from == to ? from : from + " to " + to;
}

std::string where(BesideFault const& values)
{
  return values.has_fault ? "beside the fault" : "in the body";
}

bool isOutside(Extremes const& values, PlausibleRange const& bounds)
{
  return values.smallest < bounds.from || values.largest > bounds.to;
}

std::string outside(PlausibleRange const& bounds, std::string const& unit)
{
  return ", outside the range of rocks, gels and foams, " + formatShort(bounds.from) + " to " +
         formatShort(bounds.to) + (unit.empty() ? "" : " " + unit) + ".";
}

void warnOfMaterial(BesideFault const& values, std::vector<Warning>& warnings)
{
  auto const& cs = values.shear_speed;
  if (isOutside(values.density, densities)) {
    warnings.push_back({"density", "Bulk / Density is " + interval(values.density) + " kg/m^3 " +
                                     where(values) + outside(densities, "kg/m^3") +
                                     " Is it in g/cm^3?"});
  }
  if (isOutside(values.shear_modulus, shear_moduli)) {
    warnings.push_back({"shear modulus", "The shear modulus is " + interval(values.shear_modulus) +
                                           " Pa " + where(values) + outside(shear_moduli, "Pa") +
                                           " Is it in MPa or GPa?"});
  }
  if (isOutside(cs, shear_speeds)) {
    warnings.push_back(
      {"speed of shear waves", "Shear waves travel at " + interval(cs) + " m/s " + where(values) +
                                 outside(shear_speeds, "m/s") +
                                 " Check the units of Bulk / Density and of the moduli."});
  } else if (values.density.largest > density_of_sediment && cs.smallest < speed_of_sediment) {
    warnings.push_back(
      {"speed of shear waves",
       "Shear waves travel at " + interval(cs) + " m/s " + where(values) +
         ", where the density is " + interval(values.density) +
         " kg/m^3: rocks and sediments of that density have 10 to 7000 m/s. Check the units of "
         "Bulk / Density and of the moduli."});
  }
}
} // namespace

double largestSlipRate(BesideFault const& values) { return values.shear_speed.largest / 10; }

Warning warnOfSlipRate(double slip_rate, double largest)
{
  return {"slip rate", "The slip rate has reached " + formatShort(slip_rate) +
                         " m/s, more than a tenth of the speed of shear waves beside the fault, " +
                         formatShort(10 * largest) +
                         " m/s: such slip strains the body by more than 5 %, which no rock bears "
                         "and linear elasticity does not describe. Check stresses, friction and "
                         "moduli."};
}

std::string describeSpeeds(BesideFault const& values)
{
  std::string text = std::string(values.has_fault ? "Beside the fault" : "In the body") +
                     " shear waves travel at c_s = " + interval(values.shear_speed) + " m/s";
  if (!values.is_antiplane) {
    text += ", pressure waves at c_p = " + interval(values.pressure_speed) + " m/s";
  }
  if (values.radiation_damping.largest > 0) {
    text += "; radiation damping eta = " + interval(values.radiation_damping) + " Pa s/m";
  }
  return text + (values.normal_stress.largest > 0
                   ? ". Normal stress at the start: " + interval(values.normal_stress) + " Pa."
                   : ".");
}

std::vector<Warning> warnOfImplausibleValues(BesideFault const& values)
{
  std::vector<Warning> warnings;
  warnOfMaterial(values, warnings);
  // The largest: near the surface it may be 0. Without a fault there is none.
  const double stress = values.normal_stress.largest;
  const double ratio = stress / values.shear_modulus.largest;
  if (stress > 0 && (ratio < stress_ratios.from || ratio > stress_ratios.to)) {
    warnings.push_back({"normal stress", "The largest normal stress at the start, " +
                                           formatShort(stress) + " Pa, is " + formatShort(ratio) +
                                           " of the shear modulus, " +
                                           formatShort(values.shear_modulus.largest) + " Pa" +
                                           outside(stress_ratios, "") + " Is it in MPa?"});
  }
  return warnings;
}
} // namespace asperity::dynamics
