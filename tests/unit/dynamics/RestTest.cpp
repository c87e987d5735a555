#include "dynamics/rate/FrictionProblem.hpp"

#include "base/Views.hpp"
#include "tnnmg/DenseRateMatrix.hpp"
#include "tnnmg/Tnnmg.hpp"
#include "tnnmg/direct/DenseCorrection.hpp"
#include "unit/friction/Fault.hpp"

#include <Tpetra_Core.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace asperity::dynamics
{
namespace
{
constexpr double Z = 3e3; // N s/m, drag of the body

// One node at which friction holds a load while it creeps at 1e-16 m/s or less.
struct RestingNode
{
  RestingNode()
      : node{{"Regularised", 0.025, 0.005, 5e-5, 0.7}, 2e-2, 2e3, 0, 1, alpha}
      , fault({node})
      , map(Teuchos::rcp(new Map(1, 0, Tpetra::getDefaultComm())))
  {
    const BlockView entry("Z", 1, 1);
    Kokkos::deep_copy(entry, Z);
    matrix = std::make_shared<tnnmg::DenseRateMatrix>(entry, map, 1, std::vector<int>{0});
  }

  // The load at which the node creeps at V.
  double loadFor(double V) const { return static_cast<double>(Z * V + node.force(V)); }

  tnnmg::TnnmgResult solve(FrictionProblem const& problem, double load, double& v) const
  {
    tnnmg::TnnmgSettings settings;
    settings.absolute_tolerance = 0;
    settings.relative_tolerance = 0;
    settings.max_iterations = 30; // the last ones move the node by its last digits, if at all
    tnnmg::Tnnmg solver(
      matrix, std::make_shared<tnnmg::DenseCorrection>(matrix->entries(), matrix->nodes().dofs),
      settings);
    Vector b(map), guess(map);
    b.putScalar(load);
    guess.putScalar(v);
    solver.begin(b, guess);
    const auto result = solver.solve(problem);
    v = solver.v().getData()[0];
    return result;
  }

  static constexpr double alpha = 0.003;
  friction::test::ReferenceNode node;
  friction::test::Fault fault;
  RCP<const Map> map;
  std::shared_ptr<const tnnmg::DenseRateMatrix> matrix;
};
} // namespace

// The rounding of log V exceeds that of mu here. No iteration may take it for a rise of J.
TEST(Rest, RaisesNoEnergyInTheLastDigit)
{
  const RestingNode rest;
  const FrictionProblem problem{*rest.fault.kernels, rest.fault.at};
  int energy_increases = 0;
  for (int k = 0; k < 2000; ++k) {
    const double V = 1e-16 * std::exp(-32. * k / 2000);
    double v = V * (1 - 1e-3);
    energy_increases += rest.solve(problem, rest.loadFor(V), v).energy_increases;
    EXPECT_NEAR(v, V, 1e-13 * V);
  }
  EXPECT_EQ(energy_increases, 0);
}

namespace
{
// Goes beyond the minimiser by a part of the rate.
struct BeyondTheMinimum : FrictionProblem
{
  double part;

  BeyondTheMinimum(FrictionProblem const& problem, double part_of_rate)
      : FrictionProblem(problem)
      , part(part_of_rate)
  {
  }

  int sweep(IndexView const& nodes, DenseSystem const& system, BlockView const& v) const override
  {
    const int failed = FrictionProblem::sweep(nodes, system, v);
    const double excess = part;
    Kokkos::parallel_for(
      "beyond", Kokkos::RangePolicy<ExecutionSpace>(0, 1), KOKKOS_LAMBDA(int) {
        const double before = v(0, 0);
        v(0, 0) += excess * before;
        system.r(0, 0) -= system.Z(0, 0) * (v(0, 0) - before);
      });
    return failed;
  }
};
} // namespace

TEST(Rest, CountsARiseOfTheTwelfthDigit)
{
  const RestingNode rest;
  const double V = 9e-18;
  double v = V;
  const FrictionProblem problem{*rest.fault.kernels, rest.fault.at};
  rest.solve(problem, rest.loadFor(V), v);
  const BeyondTheMinimum beyond{problem, 1e-11};
  // In the first sweep; the others start where they end, since so stiff a node is truncated.
  EXPECT_EQ(rest.solve(beyond, rest.loadFor(V), v).energy_increases, 1);
}
} // namespace asperity::dynamics
