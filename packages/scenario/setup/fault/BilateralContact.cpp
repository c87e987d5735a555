#include "scenario/setup/fault/FaultKind.hpp"

namespace asperity::scenario
{
namespace
{
struct BilateralContact final : FaultKind
{
  BilateralContact()
      : FaultKind("rate-and-state friction acts on a rigid foundation (v . n = 0).",
                  fem::OtherSide::rigid_foundation)
  {
  }
};
} // namespace

ASPERITY_REGISTER(FaultKindRegistry, "Bilateral Contact", BilateralContact)
} // namespace asperity::scenario
