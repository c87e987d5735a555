#include "fem/FaultMesh.hpp"

#include "base/parallel/Reductions.hpp"
#include "fem/BodyMatrices.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem
{
using namespace fem::test;

namespace
{
using Place = std::array<double, 3>;

// Boundaries of a body, or faults inside it, with their mesh.
template <int Dim>
struct Meshed
{
  Meshed(GlobalMesh<Dim> const& whole, Boundaries const& names, OtherSide side)
      : body(whole, conditions(names, side), Dim == 2 ? 1 : Dim)
  {
    auto const boundary = mesh::joinBoundaries(body.mesh, names);
    auto const matrices =
      assembleBody<Dim>(body.mesh, body.dofs, body.constraints.frames(),
                        std::vector<Material>(body.mesh.cells.size(), {900, 5e4, 2e4, 1e3, 1e3}));
    surface = makeFaultSurface(body.mesh, boundary, body.constraints, body.dofs,
                               *matrices.stiffness->getCrsGraph(), side);
    mesh = makeFaultMesh(body.mesh, *surface);
  }

  static std::vector<VelocityCondition<Dim>> conditions(Boundaries const& names, OtherSide side)
  {
    std::vector<VelocityCondition<Dim>> result;
    for (auto const& name : Dim == 2 ? Boundaries() : names) { // none if antiplane
      if (side.is_inside) {
        result.push_back({"Fault " + name, name, ContactAcrossFault{{name}}});
      } else {
        result.push_back({"Fault " + name, name, SlidingWall{}});
      }
    }
    return result;
  }

  bool is(int node, int axis) const // whether its fault is normal to the axis
  {
    return std::abs((*surface)[node].normal[axis]) > 0.9;
  }

  // (num_points) of a function of the place.
  template <class Function>
  std::vector<double> atPoints(Function const& f) const
  {
    return mesh->points().means(at(f), std::vector<double>(surface->numNodes(), 1.));
  }

  template <class Function>
  std::vector<double> at(Function const& f) const
  {
    std::vector<double> values;
    for (auto const& node : *surface) {
      values.push_back(f(node.place));
    }
    return values;
  }

  // K p, (num_points)
  std::vector<double> product(CrsMatrix const& K, std::vector<double> const& p) const
  {
    Vector x(K.getRowMap()), y(K.getRowMap());
    {
      auto const values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < p.size(); ++i) {
        values(i, 0) = p[i];
      }
    }
    K.apply(x, y);
    auto const values = y.getLocalViewHost(Tpetra::Access::ReadOnly);
    std::vector<double> result(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      result[i] = values(i, 0);
    }
    return result;
  }

  Constrained<Dim> body;
  std::shared_ptr<const FaultSurface> surface;
  std::shared_ptr<const FaultMesh> mesh;
};

double sumOf(std::vector<double> const& a, std::vector<double> const& b)
{
  double mine = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mine += a[i] * b[i];
  }
  return asperity::sumOverRanks(mine, *worldCommunicator());
}

// The unit cube, whose top rises by `slope` beyond its middle.
GlobalMesh<3> roofed(double slope)
{
  auto mesh = uniformCube(4);
  for (auto& x : mesh.vertices) {
    x[2] += x[2] * slope * std::max(0., x[0] - 0.5);
  }
  return mesh;
}
} // namespace

TEST(FaultMesh, OfALineHasTheEnergyOfALinearFunction)
{
  const Meshed<2> line(rectangle(0.3), {"bottom"}, OtherSide::rigid_foundation); // 3 m long
  const auto along = [](Place const& x) { return std::cos(0.3) * x[0] + std::sin(0.3) * x[1]; };
  auto const K = line.mesh->stiffness(line.at([&](Place const& x) { return 2 + along(x); }));
  auto const p = line.at([&](Place const& x) { return 5 * along(x) + 7; });
  EXPECT_NEAR(sumOf(p, line.product(*K, p)), 25 * (2 * 3 + 4.5), 1e-10);
  auto const rest = line.product(*K, line.at([](Place const&) { return 1e3; }));
  for (const double value : rest) {
    EXPECT_NEAR(value, 0, 1e-10);
  }
}

TEST(FaultMesh, OfASurfaceHasTheEnergyOfALinearFunction)
{
  const Meshed<3> square(uniformCube(4), {"top"}, OtherSide::rigid_foundation);
  auto const K = square.mesh->stiffness(square.at([](Place const& x) { return 1 + x[0]; }));
  auto const p = square.at([](Place const& x) { return 3 * x[0] - 4 * x[1] + 2 * x[2]; });
  EXPECT_NEAR(sumOf(p, square.product(*K, p)), 25 * 1.5, 1e-12);
}

TEST(FaultMesh, OfAFoldedSurfaceHasGradientsAlongIt)
{
  constexpr double slope = 0.75; // so that the rising half is 5/4 as long as wide
  const Meshed<3> roof(roofed(slope), {"top"}, OtherSide::rigid_foundation);
  auto const p =
    roof.at([](Place const& x) { return std::min(x[0], 0.5) + 1.25 * std::max(0., x[0] - 0.5); });
  auto const K = roof.mesh->stiffness(std::vector<double>(p.size(), 1.));
  EXPECT_NEAR(roof.surface->totalWeight(), 1.125, 1e-13);
  EXPECT_NEAR(sumOf(p, roof.product(*K, p)), 1.125, 1e-13);
}

TEST(FaultMesh, InsideTheBodyHasItsTips)
{
  auto whole = uniformRectangle(6, 4, 3, 2);
  mesh::addFaults<2>(whole, {{"fault", [](Point<2> const& x) {
                                return std::abs(x[1] - 1) < 1e-9 && x[0] > 0.9 && x[0] < 2.1;
                              }}});
  mesh::splitFaults(whole, "test");
  const Meshed<2> inside(whole, {"fault"}, OtherSide::body);
  auto const p = inside.at([](Place const& x) { return x[0]; });
  auto const K = inside.mesh->stiffness(std::vector<double>(p.size(), 2.));
  EXPECT_NEAR(sumOf(p, inside.product(*K, p)), 2 * 1, 1e-12);
}

namespace
{
constexpr double off = 1e-9;

// [0, 3] x [0, 2] with a fault along y = 1 and others by their conditions, and no others.
GlobalMesh<2> network(std::vector<mesh::NamedCondition<2>> faults)
{
  auto whole = uniformRectangle(6, 4, 3, 2);
  faults.push_back({"level", [](Point<2> const& x) { return std::abs(x[1] - 1) < off; }});
  mesh::addFaults<2>(whole, faults);
  mesh::splitFaults(whole, "test");
  return whole;
}

const auto is_upright = [](Point<2> const& x) { return std::abs(x[0] - 1.5) < off; };
const auto is_upper = [](Point<2> const& x) { return is_upright(x) && x[1] > 1 - off; };
const auto is_diagonal = [](Point<2> const& x) { // to the lower left
  return std::abs(x[0] - 1.5 - (x[1] - 1)) < off && x[1] < 1 + off;
};

double fromJoint(Place const& x) { return std::hypot(x[0] - 1.5, x[1] - 1); }

// What flows out of the joint at (1.5, 1) along faults on which p rises by 1 per metre, with c = 2
// on the level fault and 5 on others: the joint has one row, in which each arm has its own c.
void expectFluxes(Meshed<2> const& faults, int num_nodes, double flux)
{
  auto const& points = faults.mesh->points();
  EXPECT_EQ(sumOverRanks(faults.surface->numNodes()), num_nodes);
  EXPECT_EQ(points.numJoints(), 1);
  std::vector<double> c;
  for (int node = 0; node < faults.surface->numNodes(); ++node) {
    c.push_back(faults.is(node, 1) ? 2 : 5);
  }
  auto const K = faults.mesh->stiffness(c);
  auto const p = faults.atPoints(fromJoint);
  auto const out = faults.product(*K, p);
  double total = 0;
  int num_there = 0;
  for (std::size_t point = 0; point < p.size(); ++point) {
    total += out[point];
    if (p[point] < off) {
      ++num_there;
      EXPECT_NEAR(out[point], -flux, 1e-12);
    }
  }
  EXPECT_EQ(sumOverRanks(num_there), 1);
  EXPECT_NEAR(asperity::sumOverRanks(total, *worldCommunicator()), 0, 1e-12);
  for (const double rest : faults.product(*K, std::vector<double>(p.size(), 1e3))) {
    EXPECT_NEAR(rest, 0, 1e-10);
  }
}
} // namespace

TEST(FaultMesh, HasOneUnknownWhereFaultsCross)
{
  expectFluxes({network({{"upright", is_upright}}), {"level", "upright"}, OtherSide::body}, 7 + 5,
               2 * 2 + 2 * 5);
}

TEST(FaultMesh, HasOneUnknownWhereAFaultEndsAtAnother)
{
  expectFluxes({network({{"upper", is_upper}}), {"level", "upper"}, OtherSide::body}, 7 + 3,
               2 * 2 + 5);
}

TEST(FaultMesh, HasOneUnknownWhereFaultsEndOnBothSides)
{
  expectFluxes({network({{"diagonal", is_diagonal}, {"upper", is_upper}}),
                {"diagonal", "level", "upper"},
                OtherSide::body},
               7 + 3 + 3, 2 * 2 + 5 + 5);
}

TEST(FaultMesh, OfPartsWithNamesIsThatOfOneFault)
{
  const auto part = [](double from, double to) {
    return [=](Point<2> const& x) {
      return std::abs(x[1] - 1) < off && x[0] > from - off && x[0] < to + off;
    };
  };
  auto whole = uniformRectangle(6, 4, 3, 2);
  mesh::addFaults<2>(whole, {{"east", part(1.5, 3)}, {"west", part(0, 1.5)}});
  mesh::splitFaults(whole, "test");
  const Meshed<2> parts(whole, {"east", "west"}, OtherSide::body);
  const Meshed<2> one(network({}), {"level"}, OtherSide::body);
  EXPECT_EQ(parts.mesh->points().numJoints(), 0);
  const auto k = [](Place const& x) { return 1 + x[0]; };
  auto const p = one.at([](Place const& x) { return std::sin(x[0]); });
  auto const expected = one.product(*one.mesh->stiffness(one.at(k)), p);
  auto const found = parts.product(*parts.mesh->stiffness(parts.at(k)), p);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t point = 0; point < p.size(); ++point) {
    EXPECT_NEAR(found[point], expected[point], 1e-13);
  }
}

// Along x = 2, from y = 0 or 2 on, and along y = 2 in a box: each has 5 nodes of its own along
// x = y = 2, where they cross or the first one ends.
TEST(FaultMesh, HasOneUnknownAtEachPlaceOfALineInSpace)
{
  for (const int from : {0, 2}) {
    auto whole = uniformBox({4, 4, 4}, {4, 4, 2});
    mesh::addFaults<3>(
      whole, {{"first", [=](auto& x) { return std::abs(x[0] - 2) < off && x[1] > from - off; }},
              {"second", [](auto& x) { return std::abs(x[1] - 2) < off; }}});
    distort(whole, 0.1);
    mesh::splitFaults(whole, "test");
    const Meshed<3> faults(whole, {"first", "second"}, OtherSide::body);
    auto const& points = faults.mesh->points();
    const int num_nodes = 5 * (5 - from) + 25;
    EXPECT_EQ(sumOverRanks(faults.surface->numNodes()), num_nodes);
    EXPECT_EQ(sumOverRanks(points.numPoints()), num_nodes - 5);
    EXPECT_EQ(points.numJoints(), 5);
    std::vector<double> c;
    for (int node = 0; node < faults.surface->numNodes(); ++node) {
      c.push_back(faults.is(node, 0) ? 2 : 5);
    }
    auto const K = faults.mesh->stiffness(c);
    auto const p = faults.atPoints([](Place const& x) { return x[0] + 2 * x[1] + 3 * x[2]; });
    // Of each, c times its area times the square of the gradient along it.
    EXPECT_NEAR(sumOf(p, faults.product(*K, p)), 2 * 2 * (4 - from) * (4 + 9) + 5 * 8 * (1 + 9),
                1e-10);
    for (const double rest : faults.product(*K, std::vector<double>(p.size(), 1e3))) {
      EXPECT_NEAR(rest, 0, 1e-10);
    }
  }
}

TEST(FaultPoints, MixByWeights)
{
  // Nodes 1 and 3 are at one place, on each rank.
  const FaultPoints points({0, 1, 2, 1}, 3, *worldCommunicator());
  EXPECT_EQ(points.numJoints(), worldCommunicator()->getSize());
  EXPECT_EQ(points.sums({1, 2, 3, 4}), (std::vector<double>{1, 6, 3}));
  EXPECT_EQ(points.means({1, 2, 3, 6}, {1, 1, 1, 3}), (std::vector<double>{1, 5, 3}));
  EXPECT_EQ(points.means({1, 2, 3, 6}, {1, 0, 1, 3}), (std::vector<double>{1, 6, 3}));
  EXPECT_EQ(points.means({1, 0.1, 3, 0.1}, {1, 1. / 3, 1, 0.7}), (std::vector<double>{1, 0.1, 3}));
  const NodeView at_points("asperity::test::atPoints", 3);
  const NodeView at_nodes("asperity::test::atNodes", 4);
  points.gather(toDevice(std::vector<double>{7, 8, 9, 8}, "asperity::test::given"), at_points);
  EXPECT_EQ(toVector(at_points), (std::vector<double>{7, 8, 9}));
  points.scatter(at_points, at_nodes);
  EXPECT_EQ(toVector(at_nodes), (std::vector<double>{7, 8, 9, 8}));
}

TEST(FaultMesh, OfALinearFunctionHasItsGradientAtEveryNode)
{
  const auto expect = [](std::vector<double> const& gradient, Place const& all_over) {
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      EXPECT_NEAR(gradient[i], all_over[i % 3], 1e-12);
    }
  };
  const Meshed<2> line(rectangle(0.3), {"bottom"}, OtherSide::rigid_foundation);
  auto const c = std::cos(0.3), s = std::sin(0.3);
  expect(line.mesh->gradient(line.at([&](Place const& x) { return 5 * (c * x[0] + s * x[1]); })),
         {5 * c, 5 * s, 0});
  const Meshed<3> square(uniformCube(4), {"top"}, OtherSide::rigid_foundation);
  expect(
    square.mesh->gradient(square.at([](Place const& x) { return 3 * x[0] - 4 * x[1] + 2 * x[2]; })),
    {3, -4, 0});
}

TEST(FaultMesh, AtAKinkHasTheMeanOfTheGradientsBesideIt)
{
  const Meshed<2> line(rectangle(0), {"bottom"}, OtherSide::rigid_foundation);
  auto const p = line.at([](Place const& x) { return std::abs(x[0] - 1); });
  auto const gradient = line.mesh->gradient(p);
  for (int node = 0; node < line.surface->numNodes(); ++node) {
    const double x = (*line.surface)[node].place[0];
    EXPECT_NEAR(gradient[3 * node], std::abs(x - 1) < 1e-9 ? 0 : (x < 1 ? -1 : 1), 1e-12) << x;
  }
}

TEST(FaultMesh, SharesAPointAmongTheNodesOfItsFacet)
{
  const Meshed<3> square(uniformCube(4), {"top"}, OtherSide::rigid_foundation);
  // Inside a facet, on an edge, at a node, above the surface, and beside it.
  for (Place const& place :
       {Place{0.3, 0.4, 1}, {0.3, 0.25, 1}, {0.5, 0.75, 1}, {0.6, 0.1, 1.2}, {1.3, 0.6, 1.4}}) {
    auto const nearest = square.mesh->nearest(place);
    const Place foot = {std::min(place[0], 1.), place[1], 1};
    double sum = 0, moment_x = 0, moment_y = 0;
    for (auto const& [node, share] : nearest.shares) {
      auto const& x = (*square.surface)[node].place;
      sum += share;
      moment_x += share * x[0];
      moment_y += share * x[1];
    }
    auto const world = worldCommunicator();
    EXPECT_NEAR(asperity::sumOverRanks(sum, *world), 1, 1e-14);
    EXPECT_NEAR(asperity::sumOverRanks(moment_x, *world), foot[0], 1e-14);
    EXPECT_NEAR(asperity::sumOverRanks(moment_y, *world), foot[1], 1e-14);
    EXPECT_NEAR(nearest.distance, std::hypot(place[0] - foot[0], place[2] - 1), 1e-14);
    EXPECT_NEAR(nearest.cell_size, std::sqrt(2.) / 4, 1e-14);
  }
}
} // namespace asperity::fem
