#pragma once

#include "scenario/Problem.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The modulus G' [Pa] with which slip of wavenumber q loads the fault, G' q / 2 per slip:
//   antisymmetric fault   G antiplane, G / (1 - nu) plane strain
//   bilateral contact     2 G antiplane, 8 G (1 - nu) / (3 - 4 nu) plane strain (u_n = 0)
// In three dimensions that of antiplane, the smaller one: along one of the fault's directions slip
// is of that kind.
// The foundation is rigid: one side alone bears the slip that two share, hence about the double.
double slipModulus(fem::Material const& material, int components, bool antisymmetric);

// The size of the cohesive zone at rest, Lambda0 = G' L / (b sigma_n) [m].
double cohesiveZone(double slip_modulus, double b, double L, double sigma_n);

// Length of the patch that slip accelerates on, under the ageing law (Rubin & Ampuero 2005):
// h* = (2 / pi) G' b L / ((b - a)^2 sigma_n) for a above about b / 2, and 2.7548 Lambda0 below.
// For b > a. With the slip law nucleation is smaller.
double nucleationLength(double slip_modulus, double a, double b, double L, double sigma_n);

// Where b > a and the normal stress is not zero, over all ranks; lengths in m.
struct FaultResolution
{
  double smallest_cell; // of the fault's facets; the leg of a right triangle of the same area
  double largest_cell;
  double cohesive_zone;     // smallest
  double nucleation_length; // smallest
  double cells_per_zone;    // fewest: Lambda0 at a node over the larger cell beside it
};

// Nothing where friction weakens nowhere, or where the laws do not say what a, b and L are.
// Collective.
template <int Dim>
std::optional<FaultResolution> faultResolution(Problem<Dim> const& problem,
                                               ParameterList const& friction);

// For the log, with a warning below three cells per cohesive zone.
std::vector<std::string> describe(FaultResolution const& resolution);
} // namespace asperity::scenario
