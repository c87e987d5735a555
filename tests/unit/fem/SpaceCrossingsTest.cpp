#include "fem/BodyMatrices.hpp"
#include "fem/FaultSurface.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <functional>

// Faults that cross along a line in space: one mean and two jumps at four vertices.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
using Condition3 = VelocityCondition<3>;
constexpr double off = 1e-9;

Rotation turned() { return rotationAbout({1, -2, 3}, 0.7); }
Rotation unturned() { return rotationAbout({0, 0, 1}, 0); }

// A facet of the boundary `front` (z = 0) with its centroid there becomes one of `name`.
struct Piece
{
  std::string name;
  std::function<bool(double x, double y)> has;
};

// [0, 4] x [0, 4] x [0, 2] in cells of all shapes, with the faults `first` along x = 2 and `second`
// along y = 2, from this z on.
GlobalMesh<3> cross(Rotation const& rotation, double from = 0,
                    std::vector<Piece> const& pieces = {})
{
  auto mesh = uniformBox({4, 4, 4}, {4, 4, 2});
  mesh::addFaults<3>(
    mesh, {{"first", [=](auto& x) { return std::abs(x[0] - 2) < off && x[2] > from - off; }},
           {"second", [=](auto& x) { return std::abs(x[1] - 2) < off && x[2] > from - off; }}});
  distort(mesh, 0.1);
  for (auto const& [name, has] : pieces) {
    std::vector<GlobalMesh<3>::Facet> rest;
    for (auto const& facet : mesh.boundaries.at("front")) {
      const auto centre = mesh::centroid(mesh::corners(mesh, facet));
      (has(centre[0], centre[1]) ? mesh.boundaries[name] : rest).push_back(facet);
    }
    mesh.boundaries["front"] = rest;
  }
  rotate(mesh, rotation);
  mesh::splitFaults(mesh, "test");
  return mesh;
}

std::vector<Condition3> contact()
{
  return {{"First", "first", ContactAcrossFault{{"first"}}},
          {"Second", "second", ContactAcrossFault{{"second"}}}};
}

// The sides of both faults, 1 or -1, on which a point lies.
std::array<int, 2> sidesOf(Rotation const& rotation, Point<3> const& x)
{
  const auto place = rotatedBack(rotation, x);
  return {place[0] > 2 ? 1 : -1, place[1] > 2 ? 1 : -1};
}

// Another one in each sector.
std::vector<Material> fourMaterials(Mesh<3> const& mesh, Rotation const& rotation)
{
  std::vector<Material> materials;
  for (auto const& cell : mesh.cells) {
    const auto [first, second] =
      sidesOf(rotation, mesh::centroid(mesh::corners<3>(mesh.vertices, cell)));
    const double factor = first > 0 ? (second > 0 ? 1 : 2) : (second > 0 ? 4 : 8);
    materials.push_back({900 * factor, 5e4 * factor, 2e4 * factor, 10 * factor, 5 * factor});
  }
  return materials;
}

template <class Value>
RCP<Vector> unknowns(Constrained<3> const& body, Value const& value)
{
  std::vector<double> along_axes;
  for (int vertex = 0; vertex < body.mesh.num_owned; ++vertex) {
    const Point<3> vector = value(vertex);
    along_axes.insert(along_axes.end(), vector.begin(), vector.end());
  }
  auto const unknowns = unknownsOf(body.constraints.frames(), along_axes);
  return rcp(new Vector(body.dofs.owned(), Teuchos::arrayViewFromVector(unknowns)));
}

RCP<Vector> product(CrsMatrix const& A, Vector const& x)
{
  auto y = rcp(new Vector(A.getRangeMap()));
  A.apply(x, *y);
  return y;
}

// A vector at each vertex of the whole mesh, another one on every side; none has a part that the
// unknowns do not have.
std::vector<Point<3>> valuesAt(GlobalMesh<3> const& whole)
{
  std::vector<Point<3>> values;
  for (std::size_t v = 0; v < whole.vertices.size(); ++v) {
    const auto id = static_cast<GlobalOrdinal>(v);
    values.push_back({pseudorandom(id, 0), pseudorandom(id, 1), pseudorandom(id, 2)});
  }
  for (auto const& [mean, plus, both] : mesh::crossingsOf(whole.splits)) {
    for (int d = 0; d < 3; ++d) {
      values[both][d] = values[plus[0]][d] + values[plus[1]][d] - values[mean][d];
    }
  }
  for (auto const& split : whole.splits) {
    if (split.is_tip) {
      values[split.plus] = values[split.minus];
    }
  }
  return values;
}

int numFixed(Constrained<3> const& body, int node)
{
  return body.fixed(node, 0) + body.fixed(node, 1) + body.fixed(node, 2);
}

auto constant(double value)
{
  return [value](auto const&, double) { return value; };
}
} // namespace

TEST(SpaceCrossings, HaveTheEnergiesOfFourBodies)
{
  auto const whole = cross(turned(), 0.5);
  const Constrained<3> body(whole, contact());
  auto apart = whole;
  apart.splits.clear();
  apart.faults.clear();
  apart.boundaries.clear();
  const Constrained<3> bodies(apart, {});
  auto const matrices = assembleBody<3>(body.mesh, body.dofs, body.constraints.frames(),
                                        fourMaterials(body.mesh, turned()));
  auto const reference = assembleBody<3>(bodies.mesh, bodies.dofs, bodies.constraints.frames(),
                                         fourMaterials(bodies.mesh, turned()));
  const auto values = valuesAt(whole);
  const auto x = unknowns(body, [&](int v) { return values[body.mesh.global_ids[v]]; });
  const auto y = unknowns(bodies, [&](int v) { return values[bodies.mesh.global_ids[v]]; });
  const auto expectSame = [&](CrsMatrix const& A, CrsMatrix const& B) {
    const double expected = product(B, *y)->dot(*y);
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(product(A, *x)->dot(*x), expected, 1e-12 * expected);
  };
  expectSame(*matrices.mass, *reference.mass);
  expectSame(*matrices.viscosity, *reference.viscosity);
  expectSame(*matrices.stiffness, *reference.stiffness);
}

// Free: the mean, and both jumps within their faults. The lines end at tips of both faults.
TEST(SpaceCrossings, SlipButDoNotOpen)
{
  for (const double from : {0., 0.5}) {
    const Constrained<3> body(cross(turned(), from), contact());
    int num_crossings = 0;
    for (auto const& [mean, plus, both] : mesh::crossingsOf(body.mesh.splits)) {
      if (mean >= body.mesh.num_owned) {
        continue;
      }
      ++num_crossings;
      EXPECT_EQ(numFixed(body, mean), 0);
      EXPECT_EQ(numFixed(body, both), 3);
      for (int fault : {0, 1}) {
        EXPECT_EQ(numFixed(body, plus[fault]), 1);
        EXPECT_TRUE(body.fixed(plus[fault], 2)) << "across the fault";
        Point<3> axis{};
        axis[fault] = 1;
        const auto normal = rotated(turned(), axis);
        double across = 0;
        for (int d = 0; d < 3; ++d) {
          across += body.row(plus[fault], 2)[d] * normal[d];
        }
        EXPECT_NEAR(std::abs(across), 1, 1e-12);
      }
    }
    EXPECT_EQ(sumOverRanks(num_crossings), from == 0 ? 5 : 3);
  }
}

// Four blocks that move along both faults, in all directions: no force, and what is held is zero.
TEST(SpaceCrossings, SlideInFourBlocksWithoutForce)
{
  for (auto const& rotation : {unturned(), turned()}) {
    const Constrained<3> body(cross(rotation), contact());
    auto const matrices = assembleBody<3>(body.mesh, body.dofs, body.constraints.frames(),
                                          fourMaterials(body.mesh, rotation));
    // The sector of a vertex is that of its cells. A rank has all cells of its own vertices.
    std::vector<Point<3>> centres(body.mesh.vertices.size());
    for (auto const& cell : body.mesh.cells) {
      for (int vertex : cell) {
        centres[vertex] = mesh::centroid(mesh::corners<3>(body.mesh.vertices, cell));
      }
    }
    const Point<3> mean = {0.7, -0.2, 1.1}, first = {0, 2, -3}, second = {5, 0, 1.5};
    const auto x = unknowns(body, [&](int vertex) {
      const auto sides = sidesOf(rotation, centres[vertex]);
      Point<3> v{};
      for (int d = 0; d < 3; ++d) {
        v[d] = mean[d] + 0.5 * sides[0] * first[d] + 0.5 * sides[1] * second[d];
      }
      return rotated(rotation, v);
    });
    auto const values = x->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      for (int k : {0, 1, 2}) {
        if (body.fixed(node, k)) {
          EXPECT_NEAR(values(body.dofs.dof(node, k), 0), 0, 1e-13);
        }
      }
    }
    EXPECT_LT(product(*matrices.stiffness, *x)->normInf(), 1e-8);
    EXPECT_GT(x->norm2(), 1);
  }
}

TEST(SpaceCrossings, HaveTwoNodesAtEachPlace)
{
  Constrained<3> body(cross(unturned()), contact());
  auto const matrices = assembleBody<3>(body.mesh, body.dofs, body.constraints.frames(),
                                        fourMaterials(body.mesh, unturned()));
  const auto name = mesh::joinBoundaries(body.mesh, {"first", "second"});
  auto const surface = makeFaultSurface(body.mesh, name, body.constraints, body.dofs,
                                        *matrices.stiffness->getCrsGraph(), OtherSide::body);
  EXPECT_EQ(surface->numGlobalNodes(), 25 + 25);
  EXPECT_EQ(surface->numSliding(), 25 + 25);
  EXPECT_NEAR(surface->totalWeight(), 8 + 8, 1e-12);
  int num_there = 0;
  double of_first = 0;
  for (auto const& node : *surface) {
    const bool is_first = std::abs(node.normal[0]) > 0.5;
    of_first += is_first ? node.weight : 0;
    EXPECT_NEAR(node.normal[is_first ? 0 : 1], -1, 1e-12) << "out of the plus side";
    const bool is_there = std::abs(node.place[0] - 2) < off && std::abs(node.place[1] - 2) < off;
    EXPECT_EQ(node.copies.size(), is_there ? 4u : 2u);
    num_there += is_there ? 1 : 0;
    for (auto const& tangent : node.tangents) {
      EXPECT_NEAR(tangent[is_first ? 0 : 1], 0, 1e-12);
    }
  }
  EXPECT_EQ(sumOverRanks(num_there), 2 * 5);
  EXPECT_NEAR(asperity::sumOverRanks(of_first, *worldCommunicator()), 8, 1e-12);
}

// Where the line ends at a wall, slip goes on along it.
TEST(SpaceCrossings, EndAtAWall)
{
  auto conditions = contact();
  conditions.push_back({"Wall", "front", SlidingWall{}});
  const Constrained<3> body(cross(unturned()), conditions);
  int num_ends = 0;
  for (auto const& [mean, plus, both] : mesh::crossingsOf(body.mesh.splits)) {
    if (mean < body.mesh.num_owned && std::abs(body.mesh.vertices[mean][2]) < off) {
      ++num_ends;
      EXPECT_EQ(numFixed(body, mean), 1);
      EXPECT_EQ(numFixed(body, plus[0]), 2);
      EXPECT_EQ(numFixed(body, plus[1]), 2);
      EXPECT_EQ(numFixed(body, both), 3);
    }
  }
  EXPECT_EQ(sumOverRanks(num_ends), 1);
}

// The blocks beyond the second fault are moved along the line by 1 m/s, the others by 0.
TEST(SpaceCrossings, AreMovedByTheirBlocks)
{
  const auto is_beyond = [](double, double y) { return y > 2; };
  auto conditions = contact();
  conditions.push_back({"Here", "front", PrescribedVelocity<3>{{0, 0, 1}, constant(0)}});
  conditions.push_back({"Beyond", "beyond", PrescribedVelocity<3>{{0, 0, 1}, constant(1)}});
  const Constrained<3> body(cross(unturned(), 0, {{"beyond", is_beyond}}), conditions);
  for (auto const& [mean, plus, both] : mesh::crossingsOf(body.mesh.splits)) {
    if (mean < body.mesh.num_owned && std::abs(body.mesh.vertices[mean][2]) < off) {
      EXPECT_NEAR(body.velocity(mean, 0)[2], 0.5, 1e-14);
      EXPECT_NEAR(body.velocity(plus[0], 0).norm(), 0, 1e-14) << "slip of the first fault";
      EXPECT_NEAR(body.velocity(plus[1], 0)[2], 1, 1e-14) << "slip of the second fault";
      EXPECT_NEAR(body.velocity(both, 0).norm(), 0, 1e-14);
    }
  }
}

// One block alone: the slip of each fault would differ on the two sides of the other one.
TEST(SpaceCrossings, RefuseWhatTheirUnknownsDoNotHave)
{
  const auto is_corner = [](double x, double y) { return x > 2 && y > 2; };
  auto conditions = contact();
  conditions.push_back({"Rest", "front", PrescribedVelocity<3>{{0, 0, 1}, constant(0)}});
  conditions.push_back({"Corner", "corner", PrescribedVelocity<3>{{0, 0, 1}, constant(1)}});
  asperity::test::expectRefusal(
    [&] {
      Constrained<3>(cross(unturned(), 0, {{"corner", is_corner}}), conditions);
    },
    {"contradicts", "Rest", "Corner", "(2, 2, 0)"});
}
} // namespace asperity::fem
