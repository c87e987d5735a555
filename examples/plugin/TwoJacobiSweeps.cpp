// A smoother of your own for the V-cycle: two damped block Jacobi sweeps before and after the
// coarse correction. It takes the damping and a single sweep from multigrid/smoothers/Sweeps.hpp;
// multigrid/Smoother.hpp says what a smoother has to have.
#include "multigrid/NodeMatrix.hpp"
#include "multigrid/smoothers/Sweeps.hpp"

namespace
{
using namespace asperity::multigrid;

class TwoJacobiSweeps final : public SweepSmoother<JacobiRows>
{
public:
  static constexpr char const* meaning = "two damped block Jacobi sweeps before and after.";

  TwoJacobiSweeps() : SweepSmoother(4. / 3) {}

  // A sweep is symmetric, so that the one after the correction is also the second one before it.
  void presmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                 NodeVector const& residual) override
  {
    SweepSmoother::presmooth(matrix, b, x, residual);
    SweepSmoother::postsmooth(matrix, b, x, residual);
    Kokkos::deep_copy(residual, b);
    matrix.level.graph.share(x);
    multiplyAdd(matrix.level.graph, matrix.level.schedule, matrix.A, x, residual, -1);
  }

  void postsmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                  NodeVector const& residual) override
  {
    SweepSmoother::postsmooth(matrix, b, x, residual);
    SweepSmoother::postsmooth(matrix, b, x, residual);
  }
};
} // namespace

ASPERITY_REGISTER(SmootherRegistry, "Two Jacobi Sweeps", SmootherKindOf<TwoJacobiSweeps>)
