#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/bulk/Material.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace asperity::dynamics
{
// The modulus G' [Pa] with which slip of wavenumber q loads the fault, G' q / 2 per slip:
//   two sides deform (a mirror image, two equal bodies)
//                      G antiplane, G / (1 - nu) plane strain
//   one side deforms (on a rigid foundation)
//                      2 G antiplane, 8 G (1 - nu) / (3 - 4 nu) plane strain (u_n = 0)
// In three dimensions G' is the antiplane modulus, the smaller one, because slip along one of the
// fault's directions is antiplane. One side alone bears the slip that two sides share, so its G' is
// about twice as large.
double slipModulus(fem::Material const& material, int components, fem::OtherSide const& other_side);

// The size of the cohesive zone at zero rupture speed, Lambda0 = G' L / (b sigma_n) [m].
double cohesiveZone(double slip_modulus, double b, double L, double sigma_n);

// The nucleation length [m]: the length of the patch on which slip accelerates under the ageing law
// (Rubin & Ampuero 2005), h* = (2 / pi) G' b L / ((b - a)^2 sigma_n) for a above about b / 2, and
// 2.7548 Lambda0 below. Requires b > a. Under the slip law the patch is smaller.
double nucleationLength(double slip_modulus, double a, double b, double L, double sigma_n);

// The shortest wavelength [m] of a disturbance of steady slip that grows, pi G' L / ((b - a)
// sigma_n). It follows from linear stability and is that of every law with these a, b and L.
// Requires b > a.
double unstableWavelength(double slip_modulus, double a, double b, double L, double sigma_n);

// The same for friction that falls linearly with slip: the cohesive zone at zero rupture speed
// (Palmer & Rice 1973), 9 pi / 32 G' d_c / (drop sigma_n), and the length from which on slip cannot
// be stable (Uenishi & Rice 2003), 1.158 G' d_c / (drop sigma_n), where drop = mu_s - mu_d > 0.
double slipWeakeningZone(double slip_modulus, double drop, double distance, double sigma_n);
double slipWeakeningLength(double slip_modulus, double drop, double distance, double sigma_n);

// The parameters of friction and the normal stress at the nodes of a fault, (num_nodes) each.
struct FrictionOfNodes
{
  // Direct and evolution effect. Where the state law has a steady state of its own, a is such that
  // b - a is the largest fall of steady friction with log V at any slip rate.
  std::vector<double> a, b;
  std::vector<double> L;       // characteristic slip distance, or d_c [m]
  std::vector<double> sigma_n; // [Pa]
  // mu_s - mu_d where friction falls with slip; then a and b are empty.
  std::vector<double> drop = {};
  // Whether the node can slip under the loads of the run; empty where all can.
  std::vector<bool> can_slip = {};

  bool canSlip(int node) const { return can_slip.empty() || can_slip[node]; }
};

// (num_nodes): whether a node can slip. A place is a barrier if the shear stress that its friction
// bears, strength, exceeds the shear stress that loads put there, driving, by more than five times
// the largest shear or normal stress on the fault. Neither a rupture front, which concentrates
// about a tenth of the normal stress, nor friction that falls with slip brings as much. All [Pa].
// Collective.
std::vector<bool> canSlip(std::vector<double> const& strength, std::vector<double> const& driving,
                          std::vector<double> const& sigma_n, Communicator const& communicator);

// The cells beside a node of a fault.
struct CellSizes
{
  // Length of the smallest and largest facet [m]; in 3D the leg of a right triangle of the same
  // area.
  double smallest = std::numeric_limits<double>::max();
  double largest = 0;
  double height = 0; // largest height of a cell over the length of its facet; 0 if it is unknown
};

// (num_nodes) length of the larger facet beside each node [m], as CellSizes has it.
template <int Dim>
std::vector<double> largerCells(Mesh<Dim> const& mesh, fem::FaultSurface const& surface);

// The largest height of a cell beside the fault over the length of its facet. Facets longer than a
// fifth of the fault do not count: it is one that slips as a whole. Collective.
template <int Dim>
double highestCells(Mesh<Dim> const& mesh, fem::FaultSurface const& surface);

// L [m] where friction weakens with the slip rate and the node can slip, 0 elsewhere (num_nodes);
// with slip weakening 0 everywhere.
std::vector<double> rateWeakeningDistances(FrictionOfNodes const& friction);

// The relative error of a fault's stiffness next to bricks cut into linear cells, H times as high
// as they are long, for slip along and across a wave of `cells` cells; antiplane slip is across it,
// that of plane strain along it. Across, it is (k h)^2 (H^2 / 8 - 1 / 24); along, a fit of (k h)^2
// (c + d H^2) to the errors of verification.fault_stiffness for waves of 8 cells and more, good to
// a fifth.
struct StiffnessError
{
  std::optional<double> along, across;
};
StiffnessError stiffnessError(int components, double height, double cells);

// Extremes over all ranks' nodes that can slip, where friction weakens (b > a, or mu_s > mu_d)
// and the normal stress is positive; in m. Slip weakening has no shortest wavelength that grows:
// there it is the nucleation length.
struct FaultResolution
{
  double smallest_cell; // length of a facet; in 3D the leg of a right triangle of the same area
  double largest_cell;
  double cohesive_zone;       // smallest
  double nucleation_length;   // smallest, of the ageing law or of slip weakening
  double unstable_wavelength; // smallest
  double cells_per_zone;      // fewest: Lambda0 at a node over the larger cell beside it
  // Height of the cells beside the fault over the length of their facets, largest: 1 for squares
  // and cubes. Lower cells make the fault's stiffness more accurate (verification.fault_stiffness).
  double cell_height;
  StiffnessError too_stiff = {}; // of bricks of this height, for waves of four cohesive zones
  double slip_distance = 0;      // L, smallest
  // L / V_s, smallest [s], with a seismic slip rate V_s = 20 b sigma_n / Z. The stress drop, about
  // b sigma_n times ln(V_s / plate rate), of about 20, equals the resistance Z V_s of waves or
  // radiation damping. Z is the shear impedance over the number of sides that deform. With slip
  // weakening the drop is (mu_s - mu_d) sigma_n.
  double seismic_time = 0;
  double crossing_time = 0; // of a shear wave along a facet, smallest [s]
  // Length [m] of the part that weakens, all patches together; in 3D the root of its area.
  double weakening_length = 0;
  bool weakens_everywhere = false;
};

// Whether the part that weakens is so short that it is likely to creep without earthquakes: less
// than half of `needed`, the length [m] at which slip becomes unstable on an endless fault. A part
// of length l that ends at a free surface acts as one of length 2 l.
bool isTooShort(FaultResolution const& resolution, double needed);

// The size of a step [s] that follows an earthquake: a hundredth of seismic_time and, in a body
// with mass, at most a tenth of crossing_time.
double seismicStep(FaultResolution const& resolution, bool has_mass);

// Places of a fault, which are the nodes of one that has a mesh; arrays have an entry for each
// (num_places).
struct FaultPlaces
{
  int dimension; // of space
  fem::OtherSide other_side;
  std::vector<CellSizes> cells;
  std::vector<double> weights; // the measure of the fault's part for which each stands [m or m^2]
};

// Empty if friction weakens nowhere. materials(num_places): of the body beside the fault.
// components: of the displacement. Collective.
std::optional<FaultResolution> faultResolution(FaultPlaces const& places, int components,
                                               std::vector<fem::Material> const& materials,
                                               FrictionOfNodes const& friction,
                                               Communicator const& communicator);

// The same at the nodes of a fault with a mesh.
template <int Dim>
std::optional<FaultResolution>
faultResolution(Mesh<Dim> const& mesh, fem::FaultSurface const& surface, int components,
                std::vector<fem::Material> const& materials, FrictionOfNodes const& friction);
} // namespace asperity::dynamics
