#pragma once

#include "fem/OtherSide.hpp"
#include "registry/Registry.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// A kind of fault: a value of the entry `Type` of a boundary condition. All kinds read `Direction`,
// `Plate Rate` and `Slip Rate`, those inside the mesh also `Contact`; they differ in what lies on
// their other side. A new one, in
// FaultKind.cpp or in a library of your own, is
//
//   struct BilateralContact : FaultKind
//   {
//     BilateralContact() : FaultKind{"friction acts on ...", fem::OtherSide::rigid_foundation} {}
//   };
//   ASPERITY_REGISTER(FaultKindRegistry, "Bilateral Contact", BilateralContact)
struct FaultKind
{
  static constexpr char const* registered_as = "kind of fault";

  std::string meaning; // for the list of parameters
  fem::OtherSide other_side;
};

using FaultKindRegistry = Registry<FaultKind>;

// The names of all kinds, and of the kinds that lie inside the mesh.
std::vector<std::string> faultKinds();
std::vector<std::string> faultKindsInside();

// The name of the first kind with this other side, "" if there is none.
std::string faultKindOf(fem::OtherSide const& other_side);
} // namespace asperity::scenario
