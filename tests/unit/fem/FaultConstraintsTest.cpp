#include "unit/fem/Constrained.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Conditions along a fault: free across it, prescribed along it, continued by another boundary.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
auto constant(double value)
{
  return [value](auto const&, double) { return value; };
}

Condition free(std::string const& boundary) { return {"Fault", boundary, FreeAcrossFault{}}; }

Condition sliding(std::string const& boundary, double velocity)
{
  return {"Slip", boundary, SlipAlongTangent<2>{constant(velocity), {}}};
}

// The bottom of the rectangle in two parts, `bottom` (x < 1.5) and `beyond`, which bends upwards.
GlobalMesh<2> bentFault(double slope)
{
  auto whole = rectangle();
  auto& bottom = whole.boundaries["bottom"];
  auto& beyond = whole.boundaries["beyond"];
  for (std::size_t i = 0; i < bottom.size();) {
    const double centre = (whole.vertices[bottom[i][0]][0] + whole.vertices[bottom[i][1]][0]) / 2;
    if (centre > 1.5) {
      beyond.push_back(bottom[i]);
      bottom.erase(bottom.begin() + static_cast<long>(i));
    } else {
      ++i;
    }
  }
  for (auto& x : whole.vertices) {
    x[1] += slope * std::max(0., x[0] - 1.5) * (1 - x[1] / 2);
  }
  return whole;
}

constexpr int seam = 3; // the vertex that both parts share
} // namespace

TEST(FaultConstraints, LayFramesAlongABoundaryThatIsFreeAcross)
{
  const double angle = -0.3;
  const Constrained<2> body(rectangle(angle), {free("bottom")});
  const Eigen::Vector2d tangent(std::cos(angle), std::sin(angle));
  for (int node = 0; node < body.dofs.numLocalNodes(); ++node) {
    const bool on_fault = body.mesh.global_ids[node] <= lower_right;
    auto const first = on_fault ? tangent : Eigen::Vector2d::UnitX();
    EXPECT_LE((body.row(node, 0) - first).norm(), 1e-14);
    EXPECT_FALSE(body.fixed(node, 0) || body.fixed(node, 1));
  }
}

TEST(FaultConstraints, PrescribeTheVelocityAlongABoundary)
{
  for (double angle : {0., -0.3, 0.7, 1.2, 2.0}) {
    const Constrained<2> body(rectangle(angle), {free("bottom"), sliding("bottom", 3)});
    Eigen::Vector2d tangent(std::cos(angle), std::sin(angle));
    // The tangent points along +x unless the boundary is steep, then along +y.
    const bool steep = std::abs(tangent[0]) <= 0.4;
    tangent *= tangent[steep ? 1 : 0] < 0 ? -1 : 1;
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      if (body.mesh.global_ids[node] <= lower_right) {
        EXPECT_LE((body.row(node, 0) - tangent).norm(), 1e-14) << angle;
        EXPECT_LE((body.velocity(node, 0) - 3 * tangent).norm(), 1e-14) << angle;
        EXPECT_TRUE(body.fixed(node, 0));
        EXPECT_FALSE(body.fixed(node, 1));
      }
    }
  }
}

TEST(FaultConstraints, KeepTheTangentWhereItIsPrescribedBackwards)
{
  const double angle = 0.3;
  const Eigen::Vector2d tangent(std::cos(angle), std::sin(angle));
  const Constrained<2> body(
    rectangle(angle),
    {Condition{"Contact", "bottom", SlidingWall{}},
     Condition{"Pull", "right", PrescribedVelocity<2>{{-tangent[0], -tangent[1]}, constant(2)}}});
  const int node = body.owned(lower_right);
  if (node >= 0) {
    EXPECT_LE((body.row(node, 0) - tangent).norm(), 1e-14);
    EXPECT_LE((body.velocity(node, 0) + 2 * tangent).norm(), 1e-14);
  }
}

TEST(FaultConstraints, GiveTheSeamOfABendOneNormalAndTheSlipRate)
{
  for (bool open : {false, true}) {
    auto across = [open](std::string const& boundary, std::string const& other) {
      Condition condition{"Across", boundary, ContactAcrossFault{{other}}};
      if (open) {
        condition.kind = FreeAcrossFault{{other}};
      }
      return condition;
    };
    const Condition slip{"Slip", "beyond", SlipAlongTangent<2>{constant(2), {"bottom"}}};
    const Constrained<2> body(bentFault(0.2),
                              {across("bottom", "beyond"), across("beyond", "bottom"), slip});
    const Eigen::Vector2d tangent(std::cos(std::atan(0.2) / 2), std::sin(std::atan(0.2) / 2));
    const int node = body.owned(seam);
    if (node >= 0) {
      // The chord of facets of 1/2 m and 1/2 m times sqrt(1.04).
      EXPECT_LE((body.row(node, 0) - Eigen::Vector2d(1, 0.1).normalized()).norm(), 1e-14);
      EXPECT_LE((body.velocity(node, 0) - 2 * body.row(node, 0)).norm(), 1e-14);
      EXPECT_EQ(body.fixed(node, 1), !open);
    }
  }
}

// It steepens from 17 to 83 degrees, through the 66 degrees where +x gives way to +y. Its mean is
// steep, so that all tangents point to +y; if it falls, they point to -x where it is shallow, too.
TEST(FaultConstraints, GiveABentFaultOneSense)
{
  for (const double sign : {1., -1.}) {
    auto mesh = rectangle();
    for (auto& x : mesh.vertices) {
      x[1] += sign * (0.3 * x[0] + 1.3 * x[0] * x[0]);
    }
    for (auto const& across : {Condition{"Fault", "bottom", ContactAcrossFault{}},
                               Condition{"Fault", "bottom", FreeAcrossFault{}}}) {
      const Constrained<2> body(mesh, {across, sliding("bottom", 3)});
      for (int bottom = 0; bottom <= lower_right; ++bottom) {
        const int node = body.owned(bottom);
        if (node >= 0) {
          auto const tangent = body.row(node, 0);
          EXPECT_GT(sign * tangent[0], 0) << bottom;
          EXPECT_GT(tangent[1], 0) << bottom;
          EXPECT_LE((body.velocity(node, 0) - 3 * tangent).norm(), 1e-14) << bottom;
        }
      }
    }
  }
}

TEST(FaultConstraints, TakeAConditionAcrossAFreeBoundary)
{
  // The corner on a plane of symmetry: no velocity across the fault, which is free elsewhere.
  const Constrained<2> body(rectangle(),
                            {free("bottom"), Condition{"Symmetry", "left", AtRestAlong{{0, 1}}}});
  const int node = body.owned(0);
  if (node >= 0) {
    EXPECT_FALSE(body.fixed(node, 0));
    EXPECT_TRUE(body.fixed(node, 1));
  }
}

TEST(FaultConstraints, TakeTwoObliqueConditionsOnAFreeBoundary)
{
  const double angle = 0.3;
  const Constrained<2> body(
    rectangle(angle),
    {free("bottom"), Condition{"One", "right", PrescribedVelocity<2>{{1, 2}, constant(1)}},
     Condition{"Two", "right", PrescribedVelocity<2>{{1, 0}, constant(-3)}}});
  const int node = body.owned(lower_right);
  if (node >= 0) {
    EXPECT_LE((body.row(node, 0) - Eigen::Vector2d(std::cos(angle), std::sin(angle))).norm(),
              1e-14);
    EXPECT_NEAR(body.velocity(node, 0)[0], -3, 1e-14);
    EXPECT_NEAR(body.velocity(node, 0).dot(Eigen::Vector2d(1, 2).normalized()), 1, 1e-14);
  }
}

TEST(FaultConstraints, RefuseAConditionObliqueToAFreeBoundary)
{
  asperity::test::expectRefusal(
    [] {
      Constrained<2>(rectangle(0.3),
                     {free("bottom"), Condition{"Wall", "right", AtRestAlong{{1, 0}}}});
    },
    {"Wall", "neither along nor across", "'bottom'", "Fault"});
}

TEST(FaultConstraints, NameTheObliqueOneOfSeveralConditions)
{
  const VelocityCondition<3> open{"Fault", "bottom", FreeAcrossFault{}};
  asperity::test::expectRefusal(
    [&] {
      Constrained<3>(uniformCube(2),
                     {open, VelocityCondition<3>{"Along", "bottom", AtRestAlong{{1, 0, 0}}},
                      VelocityCondition<3>{"Oblique", "bottom", AtRestAlong{{0, 1, 1}}}});
    },
    {"Oblique prescribes", "neither along nor across", "Fault"});
}

TEST(FaultConstraints, CompareVelocitiesByTheLargestOfTheBoundary)
{
  // sin(pi) is not quite zero at the corner, where a wall is at rest; 1e-9 of the velocity is more
  // than rounding.
  auto const bow = [](double offset) {
    return
      [offset](Point<2> const& x, double) { return 1e-9 * (std::sin(M_PI * x[0] / 3) + offset); };
  };
  auto const make = [&](double offset) {
    Constrained<2>(rectangle(),
                   {Condition{"Bow", "bottom", PrescribedVelocity<2>{{1, 0}, bow(offset)}},
                    Condition{"Wall", "right", AtRestAlong{{1, 0}}},
                    Condition{"Other Wall", "left", AtRestAlong{{1, 0}}}});
  };
  EXPECT_NO_THROW(make(0));
  if (oneRank()) {
    asperity::test::expectRefusal([&] { make(1e-9); }, {"Bow", "contradicts"});
  }
}
} // namespace asperity::fem
