#include "dynamics/fault/FaultMotion.hpp"
#include "dynamics/fault/NormalStress.hpp"

#include "base/Errors.hpp"
#include "unit/dynamics/FaultNodesOfTests.hpp"
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
RCP<const Communicator> world() { return fem::test::worldCommunicator(); }

using fem::OtherSide;

// Each rank has three nodes with the dofs 0 .. T-1, T .. 2T-1, ...; weights 1, 2, 3.
// held(3 T): 1 where the velocity is prescribed.
fem::FaultSurface makeFault(int num_tangents, OtherSide other_side = OtherSide::rigid_foundation,
                            std::vector<int> held = {})
{
  held.resize(3 * num_tangents, 0);
  return dynamics::test::surfaceOf({1, 2, 3}, num_tangents, held, other_side, world());
}

BlockView blocks(std::vector<std::vector<double>> const& values)
{
  BlockView view("asperity::test::blocks", values.size(), values[0].size());
  for (std::size_t node = 0; node < values.size(); ++node) {
    for (std::size_t k = 0; k < values[node].size(); ++k) {
      view(node, k) = values[node][k];
    }
  }
  return view;
}

NodeView nodes(std::vector<double> const& values)
{
  NodeView view("asperity::test::nodes", values.size());
  std::copy(values.begin(), values.end(), view.data());
  return view;
}
} // namespace

TEST(FaultMotion, SlipRateIsTheMagnitudeOfTheVelocityInUnitsOfSlip)
{
  auto const fault = makeFault(2, OtherSide::mirror_image);
  auto const V = nodes({7, 7, 7});
  slipRate(fault, blocks({{4, -3}, {0, 0}, {-1, 1}}), V);
  EXPECT_DOUBLE_EQ(V(0), 10);
  EXPECT_EQ(V(1), 0);
  EXPECT_DOUBLE_EQ(V(2), 2 * std::sqrt(2.));
}

TEST(FaultMotion, SlowRatesDoNotUnderflow)
{
  for (double rate : {1e-300, 1e-200, 1e-150, 1e-9, 1e2}) {
    auto const line = makeFault(1);
    auto const V = nodes({1, 1, 1});
    slipRate(line, blocks({{-rate}, {rate}, {0}}), V);
    EXPECT_DOUBLE_EQ(V(0), rate);
    EXPECT_DOUBLE_EQ(V(1), rate);
    EXPECT_EQ(V(2), 0);

    auto const plane = makeFault(2);
    slipRate(plane, blocks({{3 * rate, -4 * rate}, {0, -rate}, {0, 0}}), V);
    EXPECT_NEAR(V(0), 5 * rate, 1e-15 * 5 * rate);
    EXPECT_DOUBLE_EQ(V(1), rate);
    EXPECT_EQ(V(2), 0);
  }
}

TEST(FaultMotion, PeakIsOverAllNodesAndRanks)
{
  const RCP<const Map> map = rcp(new Map(8 * world()->getSize(), 8, 0, world()));
  Vector v(map);
  v.putScalar(1e3); // dofs 6 and 7 are no fault's
  auto const fault = makeFault(2, OtherSide::mirror_image);
  const double scale = 1. + world()->getRank();
  for (double rate : {1e-300, 1e-5}) {
    {
      auto const values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
      for (int dof = 0; dof < 6; ++dof) {
        values(dof, 0) = dof == 2 ? 3 * rate * scale : (dof == 3 ? -4 * rate * scale : rate);
      }
    }
    const double expected = 10 * rate * world()->getSize();
    EXPECT_NEAR(dynamics::test::peakSlipRateAt(fault, v), expected, 1e-15 * expected);
  }
}

TEST(FaultMotion, PeakLeavesOutWhatIsPrescribed)
{
  const RCP<const Map> map = rcp(new Map(3 * world()->getSize(), 3, 0, world()));
  Vector v(map);
  for (int dof = 0; dof < 3; ++dof) {
    v.replaceLocalValue(dof, dof == 1 ? -9. : 1. + dof);
  }
  auto const side = OtherSide::rigid_foundation;
  EXPECT_DOUBLE_EQ(dynamics::test::peakSlipRateAt(makeFault(1), v), 9);
  EXPECT_DOUBLE_EQ(dynamics::test::peakSlipRateAt(makeFault(1, side, {0, 1, 0}), v), 3);
  EXPECT_EQ(dynamics::test::peakSlipRateAt(makeFault(1, side, {1, 1, 1}), v), 0);
}

TEST(FaultMotion, SlidesWhereOneComponentIsFree)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  Vector v(map);
  auto const fault = makeFault(2, OtherSide::rigid_foundation, {1, 1, 0, 1, 0, 0});
  v.replaceLocalValue(0, 9); // prescribed altogether
  v.replaceLocalValue(2, -4);
  v.replaceLocalValue(5, 3);
  EXPECT_FALSE(fault.slides(0));
  EXPECT_TRUE(fault.slides(1) && fault.slides(2));
  EXPECT_DOUBLE_EQ(dynamics::test::peakSlipRateAt(fault, v), 4);
  const BlockView beside("beside", 3, 2);
  EXPECT_FALSE(gatherPrescribedPart(fault, v, beside));
  v.replaceLocalValue(3, 1e-9);
  EXPECT_TRUE(gatherPrescribedPart(fault, v, beside));
  for (int node = 0; node < 3; ++node) {
    EXPECT_EQ(beside(node, 0), 0) << "free, or prescribed altogether";
    EXPECT_EQ(beside(node, 1), node == 1 ? 1e-9 : 0);
  }
}

// Slip rate = 2 v_t + Vp beside a mirror image.
TEST(FaultMotion, PlatesAddToTheSlipOfBodies)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  Vector v(map);
  auto const fault =
    makeFault(2, OtherSide::mirror_image, {0, 0, 0, 1, 0, 0}).withPlateRate({3, 4, 8, 0, 0, 2});
  EXPECT_TRUE(fault->hasPlateRate());
  EXPECT_FALSE(makeFault(2).hasPlateRate());
  EXPECT_DOUBLE_EQ(dynamics::test::peakSlipRateAt(*fault, v), 8);
  v.replaceLocalValue(2, -3.5);
  v.replaceLocalValue(4, 0.5);
  const BlockView w("asperity::test::w", 3, 2);
  gatherSlip(*fault, v, w);
  auto const V = nodes({7, 7, 7});
  slipRate(*fault, w, V);
  EXPECT_DOUBLE_EQ(V(0), 5);
  EXPECT_DOUBLE_EQ(V(1), 1);
  EXPECT_DOUBLE_EQ(V(2), std::sqrt(1. + 4.));
  EXPECT_DOUBLE_EQ(dynamics::test::peakSlipRateAt(*fault, v), 5);
}

// Three units in the last place are not slip; 1e-12 m/s is, and 1e-30 m/s where no plate moves.
TEST(FaultMotion, ALockedFaultDoesNotSlipByRounding)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  Vector v(map);
  auto const fault =
    makeFault(2, OtherSide::mirror_image, {0, 0, 0, 0, 0, 0}).withPlateRate({3, 4, 3, 4, 0, 0});
  v.replaceLocalValue(0, -1.5 * (1 + 4e-16));
  v.replaceLocalValue(1, -2);
  v.replaceLocalValue(2, -1.5 + 1e-12);
  v.replaceLocalValue(3, -2);
  v.replaceLocalValue(5, 1e-30); // no plate moves there
  const BlockView w("asperity::test::w", 3, 2);
  gatherSlip(*fault, v, w);
  EXPECT_EQ(w(0, 0), 0);
  EXPECT_EQ(w(0, 1), 0);
  EXPECT_NEAR(w(1, 0), 1e-12, 1e-15);
  EXPECT_EQ(w(2, 1), 1e-30);
}

// Slip = 2 (u - start) + Vp t beside a mirror image.
TEST(FaultMotion, SlipIsThatOfBodiesSinceTheStartAndThatOfPlates)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  Vector u(map);
  for (int dof = 0; dof < 6; ++dof) {
    u.replaceLocalValue(dof, dof);
  }
  auto const still = makeFault(2, OtherSide::mirror_image);
  auto const moving = still.withPlateRate({3, 4, 8, 0, 0, 2});
  auto const start = blocks({{0, 1}, {2, 2}, {2, 5}});
  auto const slip = blocks({{7, 7}, {7, 7}, {7, 7}});
  const std::vector<double> of_bodies = {0, 0, 0, 1, 2, 0}, plates = {3, 4, 8, 0, 0, 2};
  for (auto const* fault : {&still, moving.get()}) {
    gatherSlipSince(*fault, start, u, 10, slip);
    for (int i = 0; i < 6; ++i) {
      EXPECT_EQ(slip(i / 2, i % 2), of_bodies[i] + (fault == &still ? 0 : 5 * plates[i])) << i;
    }
  }
}

TEST(FaultMotion, SetsTheVelocityThatGivesASlipRate)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  auto const fault = makeFault(2, OtherSide::mirror_image, {0, 0, 0, 1, 0, 0});
  Vector v(map);
  v.putScalar(9);
  setSlipRate(fault, {2, 4, 6, 8, 10, 12}, v);
  EXPECT_EQ(v.getData()[0], 1);
  EXPECT_EQ(v.getData()[3], 9) << "held";
  EXPECT_EQ(v.getData()[5], 6);
  auto const moving = fault.withPlateRate({3, 4, 8, 0, 0, 2});
  setSlipRate(*moving, {2, 4, 6, 8, 10, 12}, v);
  EXPECT_EQ(v.getData()[0], -0.5);
  EXPECT_EQ(v.getData()[5], 5);
}

TEST(FaultMotion, AFaultThatSticksToItsPlatesDoesNotSlip)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  Vector v(map);
  v.putScalar(9);
  v.replaceLocalValue(3, 0); // held
  auto const fault =
    makeFault(2, OtherSide::mirror_image, {0, 0, 0, 1, 0, 0}).withPlateRate({3, 4, 0.1, 0, 0, 0.3});
  setZeroSlipRate(*fault, v);
  EXPECT_EQ(dynamics::test::peakSlipRateAt(*fault, v), 0);
  EXPECT_EQ(v.getData()[0], -1.5);
  EXPECT_EQ(v.getData()[3], 0);
}

// A wall across the motion of the plates: what is held slips at the plates' rate, beside what is
// free. What a wall along their motion leaves of it is rounding.
TEST(FaultMotion, WallsAcrossTheMotionOfPlatesSlip)
{
  const RCP<const Map> map = rcp(new Map(6 * world()->getSize(), 6, 0, world()));
  const Vector v(map);
  auto const fault = makeFault(2, OtherSide::rigid_foundation, {0, 1, 0, 0, 0, 0});
  const BlockView beside("beside", 3, 2);
  EXPECT_FALSE(gatherPrescribedPart(*fault.withPlateRate({3, 1e-12, 1, 1, 1, 1}), v, beside));
  EXPECT_EQ(beside(0, 1), 0);
  EXPECT_TRUE(gatherPrescribedPart(*fault.withPlateRate({3, 1e-3, 1, 1, 1, 1}), v, beside));
  EXPECT_EQ(beside(0, 1), 1e-3);
}

TEST(FaultMotion, DistanceIsTheRootMeanSquareOverAllRanks)
{
  auto const fault = makeFault(1);
  auto const a = nodes({1, 2, 3});
  auto const b = nodes({1, 5, 1});
  EXPECT_DOUBLE_EQ(distance(fault, a, b), std::sqrt((2 * 9 + 3 * 4) / 6.));
  EXPECT_EQ(distance(fault, a, a), 0);
}

TEST(FaultMotion, DistanceIsTheMaximumOverAllRanks)
{
  auto const fault = makeFault(1);
  const double scale = 1. + world()->getRank();
  auto const a = nodes({1, 2, 3});
  EXPECT_DOUBLE_EQ(distance(fault, a, nodes({1, 2 + 3 * scale, 1}), Norm::maximum),
                   3. * world()->getSize());
  EXPECT_DOUBLE_EQ(distance(fault, a, nodes({1 - 3 * scale, 2, 4}), Norm::maximum),
                   3. * world()->getSize());
  EXPECT_EQ(distance(fault, a, a, Norm::maximum), 0);
}

TEST(FaultMotion, RanksWithoutNodesDoNotCount)
{
  auto a = nodes({1, 2, 3}), b = nodes({1, 5, 1});
  const bool has_nodes = world()->getRank() == 0;
  if (!has_nodes) {
    a = b = NodeView("asperity::test::none", 0);
  }
  auto const fault =
    dynamics::test::surfaceOf(has_nodes ? std::vector<double>{1, 2, 3} : std::vector<double>{}, 1,
                              {0, 0, 0}, OtherSide::rigid_foundation, world());
  EXPECT_DOUBLE_EQ(distance(fault, a, b), std::sqrt((2 * 9 + 3 * 4) / 6.));
  EXPECT_DOUBLE_EQ(distance(fault, a, b, Norm::maximum), 3);
  EXPECT_EQ(distance(fault, a, a, Norm::maximum), 0);
  auto const none =
    dynamics::test::surfaceOf({}, 1, {0, 0, 0}, OtherSide::rigid_foundation, world());
  auto const nothing = NodeView("asperity::test::none", 0);
  EXPECT_EQ(distance(none, nothing, nothing, Norm::maximum), 0);
}

// Wherever it stands, and however large the other differences are.
TEST(FaultMotion, NotANumberIsFarFromEverythingInEitherNorm)
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
        EXPECT_FALSE(std::isfinite(distance(fault, a, b, norm))) << node;
        EXPECT_FALSE(std::isfinite(distance(fault, b, a, norm))) << node;
      }
    }
  }
}

TEST(NormalStress, IsAConstantOrAFunctionOfTime)
{
  const NormalStress constant(nodes({1, 2, 3}));
  auto const sigma_n = nodes({7, 7, 7});
  constant.at(5, sigma_n);
  EXPECT_FALSE(constant.dependsOnTime());
  EXPECT_EQ(sigma_n(0), 1);
  EXPECT_EQ(sigma_n(2), 3);
  const NormalStress moving(
    [](double t, NodeView const& view) { Kokkos::deep_copy(view, 10 * t); });
  EXPECT_TRUE(moving.dependsOnTime());
  for (double t : {2., 5., 3.}) {
    moving.at(t, sigma_n);
    EXPECT_EQ(sigma_n(0), 10 * t);
    EXPECT_EQ(sigma_n(2), 10 * t);
  }
}

TEST(FaultMotion, GathersItsDofs)
{
  const RCP<const Map> map = rcp(new Map(4 * world()->getSize(), 4, 0, world()));
  Vector v(map);
  for (int dof = 0; dof < 4; ++dof) {
    v.replaceLocalValue(dof, 10. + dof);
  }
  auto const fault = dynamics::test::surfaceWith({{3}, {0}, {2}}, world());
  auto const gathered = blocks({{0}, {0}, {0}});
  gather(fault, v, gathered);
  EXPECT_EQ(gathered(0, 0), 13);
  EXPECT_EQ(gathered(1, 0), 10);
  EXPECT_EQ(gathered(2, 0), 12);
}
} // namespace asperity::dynamics
