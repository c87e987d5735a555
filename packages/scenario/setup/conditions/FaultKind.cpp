#include "scenario/setup/conditions/FaultKind.hpp"

#include <algorithm>
#include <tuple>

namespace asperity::scenario
{
namespace
{
struct AntisymmetricFault : FaultKind
{
  AntisymmetricFault()
      : FaultKind{"friction acts on a planar fault of which the body is one half; "
                  "the slip is twice its tangential displacement, the displacement across the "
                  "fault is free and the normal stress unchanged.",
                  fem::OtherSide::mirror_image}
  {
  }
};

struct BilateralContact : FaultKind
{
  BilateralContact()
      : FaultKind{"friction acts on a rigid foundation (v . n = 0).",
                  fem::OtherSide::rigid_foundation}
  {
  }
};

struct TwoSidedFault : FaultKind
{
  TwoSidedFault()
      : FaultKind{
          "friction acts between two bodies on a fault inside the mesh, "
          "which opens if its Contact is Unilateral; several boundaries may be of this type.",
          fem::OtherSide::body}
  {
  }
};

auto asTuple(fem::OtherSide const& side)
{
  return std::tie(side.slip_factor, side.deforming_sides, side.is_inside, side.is_mirrored);
}

template <class Condition>
std::vector<std::string> kindsWith(Condition const& holds)
{
  std::vector<std::string> found;
  for (auto const& name : faultKinds()) {
    if (holds(FaultKindRegistry::instance().at(name).other_side)) {
      found.push_back(name);
    }
  }
  return found;
}
} // namespace

std::vector<std::string> faultKinds() { return FaultKindRegistry::instance().names(); }

std::vector<std::string> faultKindsInside()
{
  return kindsWith([](fem::OtherSide const& side) { return side.is_inside; });
}

std::string faultKindOf(fem::OtherSide const& other_side)
{
  auto const found =
    kindsWith([&](fem::OtherSide const& side) { return asTuple(side) == asTuple(other_side); });
  return found.empty() ? "" : found.front();
}

ASPERITY_REGISTER(FaultKindRegistry, "Antisymmetric Fault", AntisymmetricFault)
ASPERITY_REGISTER(FaultKindRegistry, "Bilateral Contact", BilateralContact)
ASPERITY_REGISTER(FaultKindRegistry, "Two-Sided Fault", TwoSidedFault)
} // namespace asperity::scenario
