#include "multigrid/smoothers/Sweeps.hpp"

namespace asperity::multigrid
{
namespace
{
// x += (D + E)^-1 (b - A x). The eigenvalues of (D + E)^-1 A are at most 4/3: errors that belong to
// the upper two thirds of them shrink to a third or less, and none grows.
class BlockJacobi final : public SweepSmoother<JacobiRows>
{
public:
  static constexpr char const* meaning =
    "a damped block Jacobi sweep before and after, the same in any order of rows.";
  BlockJacobi() : SweepSmoother(4. / 3) {}
};
} // namespace

ASPERITY_REGISTER(SmootherRegistry, "Block Jacobi", SmootherKindOf<BlockJacobi>)
} // namespace asperity::multigrid
