// Rock with a history of your own: linear kinematic hardening (Prager 1956), in which the elastic
// range keeps its size and moves with the inelastic strain, as in soil under cyclic shear. Let b be
// the back stress, the centre of the range, and n = (s - b) / sqrt((s - b) : (s - b) / 2):
//   sqrt((s - b) : (s - b) / 2) <= k,   de = n dgamma / 2,   db = H n dgamma
// fem/bulk/BulkLaw.hpp says what a law has to have.
#include "fem/bulk/BulkLaw.hpp"

namespace
{
using namespace asperity;

struct KinematicHardening
{
  static constexpr char const* name = "Kinematic Hardening";

  double strength; // k [Pa]
  double modulus;  // H [Pa]

  static constexpr ParameterOf<KinematicHardening> parameters[] = {
    {&KinematicHardening::strength,
     {"Elastic Range", "Pa", no_default, Range::positive(),
      "The rock is elastic while its shear stress is within this of the back stress."}},
    {&KinematicHardening::modulus,
     {"Hardening Modulus", "Pa", no_default, Range::positive(),
      "The back stress moves by this for each unit of inelastic shear strain."}}};

  struct History
  {
    double back_stress[fem::most_tensor_components]; // b [Pa]
  };
  static constexpr fem::VariableOf<History> history[] = {
    {&History::back_stress, {"back_stress", "Pa", "Centre of the elastic range of each element."}}};

  // Backward Euler, exact where n stays: |s1 - b1| = |s - b0| - (G + H) dgamma = k.
  KOKKOS_FUNCTION fem::InelasticChange respond(fem::TrialStress const& stress,
                                               fem::Trial const& trial, History& cell) const
  {
    double from_centre[fem::most_tensor_components];
    for (int k = 0; k < stress.size; ++k) {
      from_centre[k] = stress.deviator[k] - cell.back_stress[k];
    }
    const double distance = fem::shearOf(from_centre, stress.size);
    fem::InelasticChange change;
    if (distance <= strength) {
      return change;
    }
    change.shear = (distance - strength) / (trial.shear_modulus + modulus);
    for (int k = 0; k < stress.size; ++k) {
      const double n = from_centre[k] / distance;
      change.strain[k] = n * change.shear / 2;
      cell.back_stress[k] += modulus * n * change.shear;
    }
    return change;
  }
};
} // namespace

ASPERITY_REGISTER_BULK_LAW(KinematicHardening)
