#include "scenario/setup/fault/FaultKind.hpp"

namespace asperity::scenario
{
namespace
{
struct AntisymmetricFault final : FaultKind
{
  AntisymmetricFault()
      : FaultKind(
          "rate-and-state friction acts on a planar fault of which the body is one half; "
          "the slip is twice its tangential displacement, the displacement across the fault "
          "is free and the normal stress unchanged.",
          fem::OtherSide::mirror_image)
  {
  }
};
} // namespace

ASPERITY_REGISTER(FaultKindRegistry, "Antisymmetric Fault", AntisymmetricFault)
} // namespace asperity::scenario
