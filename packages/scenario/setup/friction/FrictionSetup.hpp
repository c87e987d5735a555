#pragma once

#include "base/Warning.hpp"
#include "dynamics/fault/NormalStress.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The deck's list `Friction`: the laws with their parameters, cohesion, normal stress and shear
// traction.
RCP<const ParameterList> frictionParameters();

// Names of its entries that its declaration and its readers share; all but the last are fields.
namespace friction_entries
{
inline constexpr char const* cohesion = "Cohesion";
inline constexpr char const* normal_stress = "Normal Stress"; // may be left out
inline constexpr char const* shear_traction = "Shear Traction";
inline constexpr char const* slip_direction = "Slip Direction";
} // namespace friction_entries

// The word of `Normal Stress Change` for friction that follows with a delay, and the entries of its
// list: a field in slip [m] and one in time [s], of which one may be left out.
inline constexpr char const* regularisation_list = "Prakash-Clifton";
inline constexpr char const* regularisation_slip = "Slip Distance";
inline constexpr char const* regularisation_time = "Time";

// The laws, and the entries of the list that are neither fields nor parameters of laws and
// processes.
struct FrictionSettings
{
  LawChoice laws;
  bool gives_normal_stress = false; // else it follows from the static solution
  double normal_stress_factor = 1;
  std::string change = "Fixed"; // of the normal stress
  double floor = 0;             // of the normal stress [Pa]
  std::vector<double> slip_direction = {1, 0, 0};

  static FrictionSettings from(ParameterList const& list);

  dynamics::NormalStressChange normalStressChange() const;
  // Whether friction follows the compression that the body exerts without a delay of its own.
  bool followsAtOnce() const;
};

// Warnings about a friction coefficient and a reference slip rate that no material has anywhere on
// the fault. Collective.
std::vector<Warning> warnOfImplausibleFriction(ParameterList const& list, FieldNodes const& nodes,
                                               Communicator const& communicator);
} // namespace asperity::scenario
