#include "fem/BoundaryMeasure.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/fem/Constrained.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

// The sense of the tangents along several faults in the plane.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
constexpr double off = 1e-9;

// Faults of these names, along edges of cells.
using Segments = std::map<std::string, std::array<Point<2>, 2>>;

GlobalMesh<2> cut(Segments const& faults, GlobalMesh<2> mesh)
{
  std::vector<mesh::NamedCondition<2>> conditions;
  for (auto const& [name, ends] : faults) {
    auto const a = ends[0], b = ends[1];
    conditions.push_back({name, [a, b](Point<2> const& x) {
                            return x[0] > a[0] - off && x[0] < b[0] + off &&
                                   x[1] > std::min(a[1], b[1]) - off &&
                                   x[1] < std::max(a[1], b[1]) + off;
                          }});
  }
  mesh::addFaults<2>(mesh, conditions);
  mesh::splitFaults(mesh, "test");
  return mesh;
}

// The tangents at the nodes of a fault that slip, in all ranks together, as sums: each component,
// and their number.
std::array<double, 3> tangentsOf(Segments const& faults, std::string const& wanted,
                                 GlobalMesh<2> const& uncut = uniformRectangle(6, 4, 3, 2))
{
  auto const whole = cut(faults, uncut);
  std::vector<std::string> names;
  for (auto const& fault : faults) {
    names.push_back(fault.first);
  }
  std::vector<Condition> conditions;
  for (auto const& name : names) {
    conditions.push_back({"Fault", name, ContactAcrossFault{names}});
  }
  const Constrained<2> body(whole, conditions);
  std::set<int> tips;
  for (auto const& split : body.mesh.splits) {
    if (split.is_tip) {
      tips.insert(split.plus);
    }
  }
  std::array<double, 3> sums{};
  for (auto const& at : boundaryMeasure(body.mesh, wanted, *worldCommunicator())) {
    const auto num_faults = std::count_if(names.begin(), names.end(), [&](std::string const& name) {
      auto const vertices = mesh::boundaryVertices(body.mesh, name);
      return std::binary_search(vertices.begin(), vertices.end(), at.node);
    });
    if (tips.count(at.node) == 0 && num_faults == 1) { // a bend has the normal of both
      auto const component =
        tangentialComponents(body.constraints.frames(), at.node, at.normal).front();
      sums[0] += body.row(at.node, component)[0];
      sums[1] += body.row(at.node, component)[1];
      sums[2] += 1;
    }
  }
  return asperity::sumOverRanks(sums, *worldCommunicator());
}

const std::array<Point<2>, 2> upright = {Point<2>{1, 0.5}, Point<2>{1, 1.5}};
} // namespace

TEST(FaultTurns, DoNotDependOnAFaultElsewhere)
{
  auto const alone = tangentsOf({{"upright", upright}}, "upright");
  EXPECT_GT(alone[2], 0);
  EXPECT_NEAR(alone[1], alone[2], 1e-12) << "+y";
  auto const beside =
    tangentsOf({{"upright", upright}, {"level", {Point<2>{1.5, 1}, Point<2>{3, 1}}}}, "upright");
  EXPECT_EQ(beside, alone);
  auto const level =
    tangentsOf({{"upright", upright}, {"level", {Point<2>{1.5, 1}, Point<2>{3, 1}}}}, "level");
  EXPECT_NEAR(level[0], level[2], 1e-12) << "+x";
}

// A fault that bends downwards under another name goes on in the same sense.
TEST(FaultTurns, GoOnWhereAnotherFaultContinues)
{
  const Segments bent = {{"level", {Point<2>{0.5, 1.5}, Point<2>{2, 1.5}}},
                         {"down", {Point<2>{2, 0.5}, Point<2>{2, 1.5}}}};
  auto const level = tangentsOf(bent, "level"), down = tangentsOf(bent, "down");
  EXPECT_GT(level[0], 0);
  EXPECT_LT(down[1], 0);
  EXPECT_GT(tangentsOf({{"down", bent.at("down")}, {"other", upright}}, "down")[1], 0) << "alone";
}

// Three upright strokes, of which the middle one is as long as the two others, and level steps of a
// fortieth of the whole between them. It is no ring: the steps have a mean, and their sense is +x.
TEST(FaultTurns, FollowTheMeanOfAnS)
{
  const Segments s = {{"at_upper", {Point<2>{0.15, 2}, Point<2>{0.15, 3}}},
                      {"lower", {Point<2>{0.2, 1}, Point<2>{0.25, 1}}},
                      {"middle", {Point<2>{0.2, 1}, Point<2>{0.2, 3}}},
                      {"at_lower", {Point<2>{0.25, 1}, Point<2>{0.25, 2}}},
                      {"upper", {Point<2>{0.15, 3}, Point<2>{0.2, 3}}}};
  auto const strip = uniformRectangle(8, 8, 0.4, 4);
  auto const left = tangentsOf(s, "at_upper", strip), right = tangentsOf(s, "at_lower", strip);
  auto const middle = tangentsOf(s, "middle", strip);
  EXPECT_GT(left[2], 0);
  EXPECT_NEAR(left[1], left[2], 1e-12) << "towards the upper step";
  EXPECT_GT(middle[2], 0);
  EXPECT_NEAR(middle[1], -middle[2], 1e-12) << "from the upper to the lower step";
  EXPECT_GT(right[2], 0);
  EXPECT_NEAR(right[1], right[2], 1e-12) << "from the lower step";
}
} // namespace asperity::fem
