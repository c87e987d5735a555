#include "multigrid/smoothers/Sweeps.hpp"

namespace asperity::multigrid
{
namespace
{
// Block Gauss-Seidel in the order of the level's schedule. Between chunks of rows and between ranks
// it is Jacobi, damped just so that D + 2 E - G is positive.
class GaussSeidel final : public SweepSmoother<GaussSeidelRows>
{
public:
  static constexpr char const* meaning =
    "a block sweep forward before and backward after the coarse correction.";
  GaussSeidel() : SweepSmoother(2) {}
};
} // namespace

ASPERITY_REGISTER(SmootherRegistry, "Gauss-Seidel", SmootherKindOf<GaussSeidel>)
} // namespace asperity::multigrid
