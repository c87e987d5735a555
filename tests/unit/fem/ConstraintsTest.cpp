#include "fem/constraints/Constraints.hpp"

#include "fem/BoundaryMeasure.hpp"
#include "unit/fem/Constrained.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem
{
using namespace fem::test;

TEST(Constraints, LayTheFramesAlongADippingBoundaryOnOwnedNodesAndGhosts)
{
  const double angle = -0.3;
  const Constrained<2> body(rectangle(angle), {Condition{"Contact", "bottom", SlidingWall{}}});
  const Eigen::Vector2d tangent(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d inward(-std::sin(angle), std::cos(angle));
  int num_ghosts_of_contact = 0;
  for (int node = 0; node < body.dofs.numLocalNodes(); ++node) {
    const bool contact = body.mesh.global_ids[node] <= lower_right;
    num_ghosts_of_contact += contact && node >= body.mesh.num_owned;
    auto const first = contact ? tangent : Eigen::Vector2d::UnitX();
    auto const last = contact ? inward : Eigen::Vector2d::UnitY();
    EXPECT_LE((body.row(node, 0) - first).norm(), 1e-14);
    EXPECT_LE((body.row(node, 1) - last).norm(), 1e-14);
    EXPECT_FALSE(body.fixed(node, 0));
    EXPECT_EQ(body.fixed(node, 1), contact);
  }
  EXPECT_TRUE(oneRank() || sumOverRanks(num_ghosts_of_contact) > 0);
}

TEST(Constraints, TakeTheNormalsOfTheBoundaryNodesWhereItBends)
{
  auto whole = rectangle();
  for (auto& x : whole.vertices) {
    x[1] += 0.3 * std::sin(1.7 * x[0]) * (1 - x[1] / 2);
  }
  const Constrained<2> body(whole, {Condition{"Contact", "bottom", SlidingWall{}}});
  auto const bottom = boundaryMeasure(body.mesh, "bottom", *worldCommunicator());
  for (auto const& each : bottom) {
    const Eigen::Vector2d outward(each.normal.data());
    EXPECT_LE((body.row(each.node, 1) + outward).norm(), 1e-14);
    EXPECT_NEAR(body.row(each.node, 0).dot(outward), 0, 1e-14);
  }
}

TEST(Constraints, KeepTheAxesWhereDirectionsAreAxes)
{
  const Constrained<2> body(
    rectangle(),
    {Condition{"Contact", "bottom", SlidingWall{}},
     Condition{"Push", "right",
               PrescribedVelocity<2>{{-5, 0}, [](auto const&, double t) { return 3 * t; }}}});
  for (int node = 0; node < body.mesh.num_owned; ++node) {
    const bool on_right = body.mesh.global_ids[node] % (lower_right + 1) == lower_right;
    EXPECT_EQ(body.constraints.frames().frame(node), NodalFrames::identity(2));
    EXPECT_EQ(body.fixed(node, 0), on_right);
    EXPECT_EQ(body.fixed(node, 1), body.mesh.global_ids[node] <= lower_right);
    EXPECT_EQ(body.velocity(node, 2), Eigen::Vector2d(on_right ? -6 : 0, 0));
  }
}

TEST(Constraints, FollowPlaceAndTimeAndLeaveFreeDofsZero)
{
  const Constrained<2> body(
    rectangle(),
    {Condition{"Push", "right", PrescribedVelocity<2>{{1, 0}, [](Point<2> const& x, double t) {
                                                        return 2 * x[1] + std::sin(t);
                                                      }}}});
  for (double t : {0., 0.3, 1e9}) {
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      auto const v = body.velocity(node, t);
      auto const& x = body.mesh.vertices[node];
      EXPECT_DOUBLE_EQ(v[0], body.fixed(node, 0) ? 2 * x[1] + std::sin(t) : 0);
      EXPECT_EQ(v[1], 0);
    }
  }
}

TEST(Constraints, FixBothDirectionsOfACorner)
{
  const double angle = 0.5;
  const Constrained<2> body(
    rectangle(angle), {Condition{"Contact", "bottom", SlidingWall{}},
                       Condition{"Backstop", "right",
                                 PrescribedVelocity<2>{{std::cos(angle), std::sin(angle)},
                                                       [](auto const&, double) { return 2.; }}}});
  const int node = body.owned(lower_right);
  if (node >= 0) {
    EXPECT_TRUE(body.fixed(node, 0) && body.fixed(node, 1));
    const Eigen::Vector2d inward(-std::sin(angle), std::cos(angle));
    EXPECT_LE((body.row(node, 1) - inward).norm(), 1e-14);
    EXPECT_LE(
      (body.velocity(node, 0) - 2 * Eigen::Vector2d(std::cos(angle), std::sin(angle))).norm(),
      1e-14);
  }
}

TEST(Constraints, MeetTwoObliqueConditionsExactly)
{
  const Eigen::Vector2d d1 = Eigen::Vector2d(1, 2).normalized();
  const Eigen::Vector2d d2 = Eigen::Vector2d(3, -1).normalized();
  auto const v1 = [](auto const&, double t) { return 1 + t; };
  auto const v2 = [](auto const&, double t) { return 5 - 3 * t; };
  // The third lies between the others and agrees with them.
  const Eigen::Vector2d sum = d1 + d2;
  auto const v3 = [&](auto const& x, double t) { return (v1(x, t) + v2(x, t)) / sum.norm(); };
  const Constrained<2> body(
    rectangle(), {Condition{"One", "bottom", PrescribedVelocity<2>{{1, 2}, v1}},
                  Condition{"Two", "right", PrescribedVelocity<2>{{3, -1}, v2}},
                  Condition{"Three", "right", PrescribedVelocity<2>{{sum[0], sum[1]}, v3}}});
  for (double t : {0., 1., 7.}) {
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      const GlobalOrdinal id = body.mesh.global_ids[node];
      auto const v = body.velocity(node, t);
      const Point<2> x{};
      if (id <= lower_right) {
        EXPECT_LE((body.row(node, 1) - d1).norm(), 1e-14);
        EXPECT_NEAR(v.dot(d1), v1(x, t), 1e-14);
      }
      if (id % (lower_right + 1) == lower_right) {
        EXPECT_NEAR(v.dot(d2), v2(x, t), 1e-13);
        EXPECT_TRUE(body.fixed(node, 0) && body.fixed(node, 1));
      }
    }
  }
}

TEST(Constraints, MeetThreeObliqueConditionsInSpace)
{
  const std::vector<Eigen::Vector3d> d = {
    {1 / 3., 2 / 3., 2 / 3.}, {0.6, 0, -0.8}, {0, 5 / 13., 12 / 13.}};
  auto const constant = [](double value) { return [value](auto const&, double) { return value; }; };
  const Constrained<3> body(
    uniformCube(2),
    {VelocityCondition<3>{"A", "bottom", PrescribedVelocity<3>{{1, 2, 2}, constant(3)}},
     VelocityCondition<3>{"B", "sides", PrescribedVelocity<3>{{3, 0, -4}, constant(-2)}},
     VelocityCondition<3>{"C", "sides", PrescribedVelocity<3>{{0, 5, 12}, constant(0.5)}}});
  for (int node = 0; node < body.dofs.numLocalNodes(); ++node) {
    auto const& x = body.mesh.vertices[node];
    const bool side = x[0] == 0 || x[0] == 1 || x[1] == 0 || x[1] == 1;
    const bool bottom = x[2] == 0;
    Eigen::Matrix3d frame;
    int num_fixed = 0;
    for (int r = 0; r < 3; ++r) {
      frame.row(r) = body.row(node, r);
      num_fixed += body.fixed(node, r);
    }
    EXPECT_LE((frame * frame.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_EQ(num_fixed, 2 * side + bottom);
    if (bottom) {
      EXPECT_LE((body.row(node, 2) - d[0]).norm(), 1e-14);
    }
    if (node < body.mesh.num_owned) {
      auto const v = body.velocity(node, 0);
      EXPECT_TRUE(!bottom || std::abs(v.dot(d[0]) - 3) <= 1e-13) << v;
      EXPECT_TRUE(!side || std::abs(v.dot(d[1]) + 2) <= 1e-13) << v;
      EXPECT_TRUE(!side || std::abs(v.dot(d[2]) - 0.5) <= 1e-13) << v;
    }
  }
}

TEST(Constraints, AcceptConditionsThatSayTheSame)
{
  auto const forward = [](auto const& x, double t) { return x[0] + t; };
  auto const backward = [](auto const& x, double t) { return -x[0] - t; };
  const Constrained<2> body(rectangle(),
                            {Condition{"One", "bottom", PrescribedVelocity<2>{{1, 0}, forward}},
                             Condition{"Two", "right", PrescribedVelocity<2>{{-1, 0}, backward}}});
  const int node = body.owned(lower_right);
  if (node >= 0) {
    EXPECT_DOUBLE_EQ(body.velocity(node, 2)[0], 5);
    EXPECT_FALSE(body.fixed(node, 1));
  }
}

TEST(Constraints, RefuseConditionsThatContradictEachOther)
{
  auto const speed = [](double value) { return [value](auto const&, double) { return value; }; };
  asperity::test::expectRefusal(
    [&] {
      Constrained<2>(
        rectangle(),
        {Condition{"Conditions / Pull", "bottom", PrescribedVelocity<2>{{1, 0}, speed(1)}},
         Condition{"Conditions / Push", "right", PrescribedVelocity<2>{{1, 0}, speed(2)}}});
    },
    {"Conditions / Pull", "'bottom'", "Conditions / Push", "'right'", "(3, 0)"});
  // Oblique conditions that agree with the first alone, but not with both.
  asperity::test::expectRefusal(
    [&] {
      Constrained<2>(rectangle(),
                     {Condition{"One", "bottom", PrescribedVelocity<2>{{1, 0}, speed(1)}},
                      Condition{"Two", "bottom", PrescribedVelocity<2>{{0, 1}, speed(1)}},
                      Condition{"Three", "right", PrescribedVelocity<2>{{1, 1}, speed(1)}}});
    },
    {"One", "Three", "contradicts"});
}

TEST(Constraints, RefuseContradictionsThatComeLater)
{
  auto const later = [](auto const&, double t) { return t < 10 ? 0. : 1.; };
  auto const make = [&](std::vector<double> const& times) {
    Constrained<2>(rectangle(),
                   {Condition{"Rest", "bottom", AtRestAlong{{1, 0}}},
                    Condition{"Push", "right", PrescribedVelocity<2>{{1, 0}, later}}},
                   2, times);
  };
  EXPECT_NO_THROW(make({0, 9}));
  asperity::test::expectRefusal([&] { make({0, 9, 20}); }, {"Rest", "Push", "t = 20 s"});
}

TEST(Constraints, RefuseWhatIsNoBoundaryOrNoDirection)
{
  if (!oneRank()) {
    GTEST_SKIP() << "said once";
  }
  asperity::test::expectRefusal(
    [] {
      Constrained<2>(rectangle(), {Condition{"Wall", "botom", SlidingWall{}}});
    },
    {"Wall", "'botom'"});
  asperity::test::expectRefusal(
    [] {
      Constrained<2>(rectangle(), {Condition{"Wall", "bottom", AtRestAlong{{0, 0}}}});
    },
    {"Wall", "direction"});
}

TEST(Constraints, OfAntiplaneMotionHaveOneDirection)
{
  const Constrained<2> body(
    rectangle(),
    {Condition{"Push", "right",
               PrescribedVelocity<2>{{-1}, [](auto const&, double) { return 2.; }}}},
    1);
  Vector v(body.dofs.owned());
  body.constraints.prescribedVelocity(0, v);
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int node = 0; node < body.mesh.num_owned; ++node) {
    const bool on_right = body.mesh.global_ids[node] % (lower_right + 1) == lower_right;
    EXPECT_EQ(body.fixed(node, 0), on_right);
    EXPECT_EQ(values(node, 0), on_right ? -2 : 0);
  }
}
} // namespace asperity::fem
