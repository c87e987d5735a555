#include "scenario/setup/fault/FaultKind.hpp"

namespace asperity::scenario
{
namespace
{
struct TwoSidedFault final : FaultKind
{
  TwoSidedFault()
      : FaultKind("rate-and-state friction acts between two bodies on a fault inside the mesh, "
                  "which does not open; several boundaries may be of this type.",
                  fem::OtherSide::body)
  {
  }
};
} // namespace

ASPERITY_REGISTER(FaultKindRegistry, "Two-Sided Fault", TwoSidedFault)
} // namespace asperity::scenario
