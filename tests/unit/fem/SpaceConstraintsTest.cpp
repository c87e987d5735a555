#include "fem/BoundaryMeasure.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "unit/fem/Constrained.hpp"

#include <gtest/gtest.h>

#include <functional>

// Frames on a fault in space, where it dips and bends, and where it ends at walls and surfaces.
namespace asperity::fem
{
using namespace fem::test;
using Eigen::Vector3d;

namespace
{
using Condition3 = VelocityCondition<3>;

auto constant(double value)
{
  return [value](auto const&, double) { return value; };
}

// A box whose bottom, the fault, is moved up by a function of x and z.
GlobalMesh<3> boxOn(std::function<double(double, double)> const& height)
{
  auto mesh = uniformBox({4, 3, 3}, {2, 1.5, 1});
  for (auto& x : mesh.vertices) {
    x[1] += height(x[0], x[2]) * (1 - x[1] / 1.5);
  }
  return mesh;
}

double dipping(double x, double) { return 0.3 * x; }
double bent(double x, double z) { return 0.3 * x + 0.1 * x * x + 0.2 * z * z; }

Condition3 across(std::string const& name, std::string const& boundary)
{
  return {name, boundary, SlidingWall{}};
}

Condition3 free(std::string const& boundary) { return {"Fault", boundary, FreeAcrossFault{}}; }

struct Body : Constrained<3>
{
  using Constrained<3>::Constrained;

  // Unit inward normals of the owned nodes of a boundary, from its facets alone.
  std::map<int, Vector3d> normals(std::string const& boundary) const
  {
    std::map<int, Vector3d> result;
    auto const nodes = boundaryMeasure(mesh, boundary, *worldCommunicator());
    for (auto const& each : nodes) {
      result[each.node] = -Vector3d(each.normal.data());
    }
    return result;
  }

  std::vector<int> tangents(int node, Vector3d const& normal) const
  {
    return tangentialComponents(constraints.frames(), node,
                                Point<3>{normal[0], normal[1], normal[2]});
  }

  int numFixed(int node) const { return fixed(node, 0) + fixed(node, 1) + fixed(node, 2); }

  double orthonormality(int node) const
  {
    Eigen::Matrix3d frame;
    frame << row(node, 0).transpose(), row(node, 1).transpose(), row(node, 2).transpose();
    return (frame * frame.transpose() - Eigen::Matrix3d::Identity()).norm();
  }
};

bool at(Body const& body, int node, int axis, double coordinate)
{
  return std::abs(body.mesh.vertices[node][axis] - coordinate) < 1e-12;
}
} // namespace

TEST(SpaceConstraints, LayTwoTangentsAndTheNormalOfAFault)
{
  for (auto const& height : {dipping, bent}) {
    const Body body(boxOn(height), {across("Fault", "bottom")});
    auto const normals = body.normals("bottom");
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      EXPECT_LE(body.orthonormality(node), 1e-14);
      auto const found = normals.find(node);
      if (found == normals.end()) {
        EXPECT_EQ(body.row(node, 0), Vector3d::UnitX());
        EXPECT_EQ(body.numFixed(node), 0);
        continue;
      }
      EXPECT_LE((body.row(node, 2) - found->second).norm(), 1e-14);
      EXPECT_GT(body.row(node, 0)[0], 0.8) << "near the first axis";
      EXPECT_GT(body.row(node, 1)[2], 0.8) << "near the other axis along the fault";
      EXPECT_TRUE(body.fixed(node, 2));
      EXPECT_EQ(body.numFixed(node), 1) << "also where the fault meets the surface";
      EXPECT_EQ(body.tangents(node, found->second), (std::vector<int>{0, 1}));
    }
  }
}

TEST(SpaceConstraints, FollowTheWallWithinTheFaultWhereTheyMeet)
{
  // The left wall is oblique to the fault, the one in front stands on it.
  for (auto const* wall : {"left", "front"}) {
    const Body body(boxOn(bent), {across("Fault", "bottom"), across("Wall", wall)});
    auto const of_fault = body.normals("bottom");
    int num_edge = 0;
    for (auto const& [node, of_wall] : body.normals(wall)) {
      auto const found = of_fault.find(node);
      if (found == of_fault.end()) {
        EXPECT_EQ(body.numFixed(node), 1);
        continue;
      }
      ++num_edge;
      auto const& normal = found->second;
      const Vector3d in_fault = (of_wall - of_wall.dot(normal) * normal).normalized();
      auto const tangents = body.tangents(node, normal);
      EXPECT_LE(body.orthonormality(node), 1e-14);
      EXPECT_LE((body.row(node, 2) - normal).norm(), 1e-14);
      EXPECT_EQ(tangents, (std::vector<int>{0, 1}));
      EXPECT_LE((body.row(node, 1) - in_fault).norm(), 1e-14);
      EXPECT_LE(body.row(node, 0).cross(normal.cross(of_wall).normalized()).norm(), 1e-14);
      EXPECT_FALSE(body.fixed(node, 0));
      EXPECT_TRUE(body.fixed(node, 1) && body.fixed(node, 2));
    }
    EXPECT_EQ(sumOverRanks(num_edge), std::string(wall) == "left" ? 4 : 5);
  }
}

TEST(SpaceConstraints, HoldACornerOfThreeWalls)
{
  const Body body(boxOn(bent), {across("Fault", "bottom"), across("Wall", "left"),
                                across("Other Wall", "front"), across("Lid", "top")});
  auto const on_fault = body.normals("bottom");
  for (int node = 0; node < body.mesh.num_owned; ++node) {
    const bool left = at(body, node, 0, 0), front = at(body, node, 2, 0);
    const bool bottom = on_fault.count(node) > 0, top = at(body, node, 1, 1.5);
    EXPECT_EQ(body.numFixed(node), left + front + bottom + top);
    EXPECT_EQ(body.velocity(node, 0), Vector3d::Zero());
  }
}

TEST(SpaceConstraints, MeetAVelocityObliqueToWallsAndFault)
{
  const Vector3d d = Vector3d(1, 2, 0.5).normalized();
  const Body body(boxOn(bent),
                  {across("Fault", "bottom"), across("Wall", "front"),
                   Condition3{"Push", "right", PrescribedVelocity<3>{{1, 2, 0.5}, constant(3)}}});
  auto const on_fault = body.normals("bottom");
  for (auto const& entry : body.normals("right")) {
    const int node = entry.first;
    auto const v = body.velocity(node, 0);
    EXPECT_NEAR(v.dot(d), 3, 1e-13);
    EXPECT_TRUE(!at(body, node, 2, 0) || std::abs(v[2]) < 1e-13);
    if (on_fault.count(node) > 0) {
      EXPECT_NEAR(v.dot(on_fault.at(node)), 0, 1e-13);
      EXPECT_LE((body.row(node, 2) - on_fault.at(node)).norm(), 1e-14);
    }
  }
}

TEST(SpaceConstraints, RefuseContradictionsAtACorner)
{
  asperity::test::expectRefusal(
    [] {
      Body(boxOn(dipping),
           {across("Fault", "bottom"), across("Wall", "front"), across("Side", "left"),
            Condition3{"Push", "left", PrescribedVelocity<3>{{1, 1, 1}, constant(3)}}});
    },
    {"Push", "contradicts", "'left'", "x = (0, 0, 0)"});
}

// On a bent fault the facets of one side of a wall miss its plane by their size, so that their
// normals would be oblique to it; with their mirror images they are not.
TEST(SpaceConstraints, LayTheNormalOfAFreeFaultIntoTheWallsThatItEndsAt)
{
  auto const cylinder = [](double x, double) { return 0.3 * x + 0.1 * x * x; };
  auto whole = boxOn(cylinder);
  for (auto& x : whole.vertices) {
    if (x[2] > 0 && x[2] < 1) { // the triangles of the fault are no mirror images of each other
      const double moved = x[0] + 0.1 * std::sin(M_PI * x[0] / 2) * (1 + x[2]);
      x[1] += (cylinder(moved, 0) - cylinder(x[0], 0)) * (1 - x[1] / 1.5);
      x[0] = moved;
    }
  }
  auto fault = free("bottom");
  const Condition3 slip{"Slip", "bottom", SlipTowards<3>{{1, 0, 0}, constant(2), {}}};
  const Condition3 locked{"Slip", "bottom", NoSlipSideways{{1, 0, 0}, {}}};
  for (bool slips : {false, true}) {
    std::vector<Condition3> conditions = {fault, across("Front", "front"), across("Back", "back")};
    if (slips) {
      conditions.insert(conditions.end(), {slip, locked});
    }
    const Body body(whole, conditions);
    double largest = 0;
    for (auto const& [node, of_facets] : body.normals("bottom")) {
      auto const tangents = body.tangents(node, of_facets);
      EXPECT_EQ(tangents, (std::vector<int>{0, 1}));
      EXPECT_LE(body.orthonormality(node), 1e-14);
      EXPECT_FALSE(body.fixed(node, 2));
      const bool at_wall = at(body, node, 2, 0) || at(body, node, 2, 1);
      if (at_wall) {
        largest = std::max(largest, std::abs(of_facets[2]));
        EXPECT_LE(std::abs(body.row(node, 2)[2]), 1e-15);
        EXPECT_LE((body.row(node, 2) - of_facets).norm(), 0.1);
        EXPECT_NEAR(std::abs(body.row(node, 1)[2]), 1, 1e-15);
      }
      EXPECT_EQ(body.fixed(node, 0), slips);
      EXPECT_EQ(body.fixed(node, 1), slips || at_wall);
      if (slips) {
        auto const normal = body.row(node, 2);
        const Vector3d along = (Vector3d::UnitX() - normal[0] * normal).normalized();
        EXPECT_LE((body.velocity(node, 0) - 2 * along).norm(), 1e-13);
      }
    }
    EXPECT_TRUE(!oneRank() || largest > 1e-3) << "normals of the facets miss the wall's plane";
  }
}

TEST(SpaceConstraints, RefuseWallsObliqueToAFreeFault)
{
  asperity::test::expectRefusal(
    [] {
      Body(boxOn(dipping), {free("bottom"), across("Wall", "left")});
    },
    {"Wall", "neither along nor across", "'bottom'", "x = (0, 0, ", "Fault"});
}

TEST(SpaceConstraints, RefuseASlipDirectionAcrossTheFault)
{
  if (!oneRank()) {
    GTEST_SKIP() << "said once";
  }
  const Condition3 slip{"Slip", "top", SlipTowards<3>{{0, -2, 0}, constant(0), {}}};
  asperity::test::expectRefusal([&] { Body(boxOn(dipping), {slip}); },
                                {"Slip", "(0, -2, 0)", "'top'"});
}

TEST(TangentialComponents, AreThoseFarFromTheNormal)
{
  NodalFrames frames(1, 3);
  EXPECT_EQ(tangentialComponents(frames, 0, Point<3>{0, -1, 0}), (std::vector<int>{0, 2}));
  EXPECT_EQ(tangentialComponents(frames, 0, Point<3>{-0.8, 0.6, 0}), (std::vector<int>{1, 2}));
  frames.set(0, {0.6, 0, 0.8, 0, 1, 0, -0.8, 0, 0.6});
  EXPECT_EQ(tangentialComponents(frames, 0, Point<3>{-0.6, 0.1, -0.75}), (std::vector<int>{1, 2}));
  const NodalFrames plane(1, 2), antiplane(1, 1);
  EXPECT_EQ(tangentialComponents(plane, 0, Point<2>{0.1, -1}), (std::vector<int>{0}));
  EXPECT_EQ(tangentialComponents(plane, 0, Point<2>{1, 0.1}), (std::vector<int>{1}));
  EXPECT_EQ(tangentialComponents(antiplane, 0, Point<2>{1, 0}), (std::vector<int>{0}));
}
} // namespace asperity::fem
