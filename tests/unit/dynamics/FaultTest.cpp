#include "dynamics/Fault.hpp"

#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
RCP<const Communicator> world() { return fem::testing::worldCommunicator(); }

// Each rank has three nodes with the dofs 0 .. T-1, T .. 2T-1, ...; weights 1, 2, 3.
Fault makeFault(int num_tangents)
{
  Fault fault;
  fault.num_tangents = num_tangents;
  fault.communicator = world();
  friction::NodeView weight("asperity::test::weight", 3);
  for (int node = 0; node < 3; ++node) {
    fault.dofs.emplace_back();
    for (int k = 0; k < num_tangents; ++k) {
      fault.dofs[node].push_back(node * num_tangents + k);
    }
    fault.fixed.emplace_back(num_tangents, 0);
    weight(node) = node + 1;
  }
  fault.data.weight = weight;
  fault.total_weight = 6 * world()->getSize();
  return fault;
}

friction::BlockView blocks(std::vector<std::vector<double>> const& values)
{
  friction::BlockView view("asperity::test::blocks", values.size(), values[0].size());
  for (std::size_t node = 0; node < values.size(); ++node) {
    for (std::size_t k = 0; k < values[node].size(); ++k) {
      view(node, k) = values[node][k];
    }
  }
  return view;
}

friction::NodeView nodes(std::vector<double> const& values)
{
  friction::NodeView view("asperity::test::nodes", values.size());
  std::copy(values.begin(), values.end(), view.data());
  return view;
}
} // namespace

TEST(Fault, slipRateIsTheMagnitudeOfTheVelocityInUnitsOfSlip)
{
  auto fault = makeFault(2);
  fault.slip_factor = 2;
  auto const V = nodes({7, 7, 7});
  fault.slipRate(blocks({{4, -3}, {0, 0}, {-1, 1}}), V);
  EXPECT_DOUBLE_EQ(V(0), 10);
  EXPECT_EQ(V(1), 0);
  EXPECT_DOUBLE_EQ(V(2), 2 * std::sqrt(2.));
}

TEST(Fault, slowRatesDoNotUnderflow)
{
  for (double rate : {1e-300, 1e-200, 1e-150, 1e-9, 1e2}) {
    auto line = makeFault(1);
    auto const V = nodes({1, 1, 1});
    line.slipRate(blocks({{-rate}, {rate}, {0}}), V);
    EXPECT_DOUBLE_EQ(V(0), rate);
    EXPECT_DOUBLE_EQ(V(1), rate);
    EXPECT_EQ(V(2), 0);

    auto plane = makeFault(2);
    plane.slipRate(blocks({{3 * rate, -4 * rate}, {0, -rate}, {0, 0}}), V);
    EXPECT_NEAR(V(0), 5 * rate, 1e-15 * 5 * rate);
    EXPECT_DOUBLE_EQ(V(1), rate);
    EXPECT_EQ(V(2), 0);
  }
}

TEST(Fault, peakIsOverAllNodesAndRanks)
{
  const RCP<const Map> map = rcp(new Map(8 * world()->getSize(), 8, 0, world()));
  Vector v(map);
  v.putScalar(1e3); // dofs 6 and 7 are no fault's
  auto fault = makeFault(2);
  fault.slip_factor = 2;
  const double scale = 1. + world()->getRank();
  for (double rate : {1e-300, 1e-5}) {
    {
      auto const values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
      for (int dof = 0; dof < 6; ++dof) {
        values(dof, 0) = dof == 2 ? 3 * rate * scale : (dof == 3 ? -4 * rate * scale : rate);
      }
    }
    const double expected = 10 * rate * world()->getSize();
    EXPECT_NEAR(fault.peakSlipRate(v), expected, 1e-15 * expected);
  }
}

TEST(Fault, peakLeavesOutWhatIsPrescribed)
{
  const RCP<const Map> map = rcp(new Map(3 * world()->getSize(), 3, 0, world()));
  Vector v(map);
  for (int dof = 0; dof < 3; ++dof) {
    v.replaceLocalValue(dof, dof == 1 ? -9. : 1. + dof);
  }
  auto fault = makeFault(1);
  EXPECT_DOUBLE_EQ(fault.peakSlipRate(v), 9);
  fault.fixed = {{0}, {1}, {0}};
  EXPECT_DOUBLE_EQ(fault.peakSlipRate(v), 3);
  fault.fixed = {{1}, {1}, {1}};
  EXPECT_EQ(fault.peakSlipRate(v), 0);
}

TEST(Fault, slidesWhereOneComponentIsFree)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  Vector v(map);
  auto fault = makeFault(2);
  fault.fixed = {{1, 1}, {0, 1}, {0, 0}};
  v.replaceLocalValue(0, 9); // prescribed altogether
  v.replaceLocalValue(2, -4);
  v.replaceLocalValue(5, 3);
  EXPECT_FALSE(fault.slides(0));
  EXPECT_TRUE(fault.slides(1) && fault.slides(2));
  EXPECT_DOUBLE_EQ(fault.peakSlipRate(v), 4);
  EXPECT_NO_THROW(fault.requireWalls(v, 2, 0));
  v.replaceLocalValue(3, 1e-9);
  EXPECT_THROW(fault.requireWalls(v, 2, 0), InputError);
}

TEST(Fault, distanceIsTheRootMeanSquareOverAllRanks)
{
  auto const fault = makeFault(1);
  auto const a = nodes({1, 2, 3});
  auto const b = nodes({1, 5, 1});
  EXPECT_DOUBLE_EQ(fault.distance(a, b), std::sqrt((2 * 9 + 3 * 4) / 6.));
  EXPECT_EQ(fault.distance(a, a), 0);
}

TEST(Fault, distanceIsTheMaximumOverAllRanks)
{
  auto const fault = makeFault(1);
  const double scale = 1. + world()->getRank();
  auto const a = nodes({1, 2, 3});
  EXPECT_DOUBLE_EQ(fault.distance(a, nodes({1, 2 + 3 * scale, 1}), Norm::maximum),
                   3. * world()->getSize());
  EXPECT_DOUBLE_EQ(fault.distance(a, nodes({1 - 3 * scale, 2, 4}), Norm::maximum),
                   3. * world()->getSize());
  EXPECT_EQ(fault.distance(a, a, Norm::maximum), 0);
}

TEST(Fault, ranksWithoutNodesDoNotCount)
{
  auto fault = makeFault(1);
  auto a = nodes({1, 2, 3}), b = nodes({1, 5, 1});
  if (world()->getRank() > 0) {
    fault.dofs.clear();
    fault.fixed.clear();
    a = b = friction::NodeView("asperity::test::none", 0);
    fault.data.weight = a;
  }
  fault.total_weight = 6;
  EXPECT_DOUBLE_EQ(fault.distance(a, b), std::sqrt((2 * 9 + 3 * 4) / 6.));
  EXPECT_DOUBLE_EQ(fault.distance(a, b, Norm::maximum), 3);
  EXPECT_EQ(fault.distance(a, a, Norm::maximum), 0);
  fault.dofs.clear(); // nor on any other rank
  EXPECT_EQ(fault.distance(a, b, Norm::maximum), 0);
}

// Wherever it stands, and however large the other differences are.
TEST(Fault, notANumberIsFarFromEverythingInEitherNorm)
{
  auto const fault = makeFault(1);
  auto const b = nodes({10, 20, 30});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int node = 0; node < 3; ++node) {
    for (double broken : {nan, std::numeric_limits<double>::infinity()}) {
      auto const a = nodes({1, 2, 3});
      if (world()->getRank() == world()->getSize() - 1) {
        a(node) = broken;
      }
      for (auto norm : {Norm::root_mean_square, Norm::maximum}) {
        EXPECT_FALSE(std::isfinite(fault.distance(a, b, norm))) << node;
        EXPECT_FALSE(std::isfinite(fault.distance(b, a, norm))) << node;
      }
    }
  }
}

TEST(Fault, setTimeFillsTheNormalStressThatFrictionSees)
{
  auto fault = makeFault(1);
  fault.normal_stress = nodes({1, 2, 3});
  fault.data.sigma_n = fault.normal_stress;
  fault.setTime(5); // nothing changes
  EXPECT_EQ(fault.data.sigma_n(2), 3);
  fault.normal_stress_at = [](double t, friction::NodeView const& view) {
    Kokkos::deep_copy(view, 10 * t);
  };
  for (double t : {2., 5., 3.}) {
    fault.setTime(t);
    EXPECT_EQ(fault.data.sigma_n(0), 10 * t);
    EXPECT_EQ(fault.data.sigma_n(2), 10 * t);
  }
}

TEST(Fault, gathersItsDofs)
{
  const RCP<const Map> map = rcp(new Map(4 * world()->getSize(), 4, 0, world()));
  Vector v(map);
  for (int dof = 0; dof < 4; ++dof) {
    v.replaceLocalValue(dof, 10. + dof);
  }
  auto fault = makeFault(1);
  fault.dofs = {{3}, {0}, {2}};
  auto const gathered = blocks({{0}, {0}, {0}});
  fault.gather(v, gathered);
  EXPECT_EQ(gathered(0, 0), 13);
  EXPECT_EQ(gathered(1, 0), 10);
  EXPECT_EQ(gathered(2, 0), 12);
  EXPECT_EQ(fault.sumOverRanks(3), 3 * world()->getSize());
}
} // namespace asperity::dynamics
