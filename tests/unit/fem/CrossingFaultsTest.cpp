#include "fem/BodyMatrices.hpp"
#include "fem/BoundaryCells.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/motions/BodyPieces.hpp"
#include "fem/motions/RigidBodyMotions.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "portability/Renamed.hpp"
#include "unit/fem/Constrained.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

// Faults that cross in the plane: one mean and two jumps at four vertices.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
constexpr double off = 1e-9;
constexpr double size_x = 3, size_y = 2;

// [0, 3] x [0, 2] with faults along y = 1 and along x = 1.5, which go through or end 1/2 from the
// sides, turned about the origin.
GlobalMesh<2> cross(double angle = 0, bool go_through = true)
{
  auto mesh = uniformRectangle(6, 4, size_x, size_y);
  const double from = go_through ? 0 : 0.5;
  mesh::addFaults<2>(
    mesh, {{"level",
            [=](Point<2> const& x) {
              return std::abs(x[1] - 1) < off && x[0] > from - off && x[0] < size_x - from + off;
            }},
           {"upright", [=](Point<2> const& x) {
              return std::abs(x[0] - 1.5) < off && x[1] > from - off && x[1] < size_y - from + off;
            }}});
  rotate(mesh, angle);
  mesh::splitFaults(mesh, "test");
  return mesh;
}

std::vector<Condition> contact()
{
  return {{"Level", "level", ContactAcrossFault{{"level"}}},
          {"Upright", "upright", ContactAcrossFault{{"upright"}}}};
}

// Another one in each quadrant.
std::vector<Material> fourMaterials(Mesh<2> const& mesh, double angle = 0)
{
  std::vector<Material> materials;
  for (auto const& cell : mesh.cells) {
    Point<2> x{};
    for (int vertex : cell) {
      for (int d = 0; d < 2; ++d) {
        x[d] += mesh.vertices[vertex][d] / 3;
      }
    }
    const bool right = std::cos(angle) * x[0] + std::sin(angle) * x[1] > 1.5,
               upper = std::cos(angle) * x[1] - std::sin(angle) * x[0] > 1;
    const double factor = right ? (upper ? 1 : 2) : (upper ? 4 : 8);
    materials.push_back({900 * factor, 5e4 * factor, 2e4 * factor, 10 * factor, 5 * factor});
  }
  return materials;
}

// A vector at each vertex of the whole mesh, another one on every side. At a crossing the four have
// no part that the unknowns do not have, and nothing jumps at a tip.
std::vector<Point<2>> valuesAt(GlobalMesh<2> const& whole)
{
  std::vector<Point<2>> values;
  for (std::size_t v = 0; v < whole.vertices.size(); ++v) {
    const auto id = static_cast<GlobalOrdinal>(v);
    values.push_back({pseudorandom(id, 0), pseudorandom(id, 1)});
  }
  for (auto const& [mean, plus, both] : mesh::crossingsOf(whole.splits)) {
    for (int d = 0; d < 2; ++d) {
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

template <class Value>
RCP<Vector> unknowns(Constrained<2> const& body, Value const& value)
{
  std::vector<double> along_axes;
  for (int vertex = 0; vertex < body.mesh.num_owned; ++vertex) {
    const Point<2> vector = value(vertex);
    along_axes.insert(along_axes.end(), vector.begin(), vector.begin() + body.dofs.components());
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

// The most that rounding leaves of forces K x that are zero. A force sums n products of a row, each
// at most the largest entry of K times the largest of x. A product carries less than n + 40
// relative errors of half of epsilon: n of this sum, and less than 40 of its factors, of which an
// entry of K sums at most 8 cells and takes some 30 operations in each. Those of a sum over cells
// are relative to the largest entry of K at most: matrices of cells are positive semidefinite, so
// that no partial sum has an entry larger than the largest of the whole.
double roundingOf(CrsMatrix const& K, Vector const& x)
{
  auto const values = K.getLocalMatrixHost().values;
  double largest = 0;
  for (std::size_t i = 0; i < values.extent(0); ++i) {
    largest = std::max(largest, std::abs(values(i)));
  }
  const auto communicator = worldCommunicator();
  const double n = maxOverRanks(static_cast<double>(maxLocalRowEntries(K)), *communicator);
  constexpr double half_epsilon = std::numeric_limits<double>::epsilon() / 2;
  return n * (n + 40) * half_epsilon * maxOverRanks(largest, *communicator) * x.normInf();
}

// The owned crossing, if this rank has it.
std::optional<mesh::Crossing> ownedCrossing(Mesh<2> const& mesh)
{
  for (auto const& crossing : mesh::crossingsOf(mesh.splits)) {
    if (crossing.mean < mesh.num_owned) {
      return crossing;
    }
  }
  return std::nullopt;
}

std::shared_ptr<const FaultSurface> surfaceOf(Constrained<2>& body, BodyMatrices const& matrices)
{
  const auto name = mesh::joinBoundaries(body.mesh, {"level", "upright"});
  return makeFaultSurface(body.mesh, name, body.constraints, body.dofs,
                          *matrices.stiffness->getCrsGraph(), OtherSide::body);
}
} // namespace

TEST(CrossingFaults, HaveTheEnergiesOfFourBodies)
{
  for (int components : {1, 2}) {
    for (double angle : {0., 0.4}) {
      auto const whole = cross(angle);
      const Constrained<2> body(whole, components == 2 ? contact() : std::vector<Condition>(),
                                components);
      auto apart = whole;
      apart.splits.clear();
      apart.faults.clear();
      apart.boundaries.clear();
      const Constrained<2> bodies(apart, {}, components);
      auto const matrices =
        assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(), fourMaterials(body.mesh));
      auto const reference = assembleBody<2>(bodies.mesh, bodies.dofs, bodies.constraints.frames(),
                                             fourMaterials(bodies.mesh));
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
  }
}

TEST(CrossingFaults, HaveSymmetricMatrices)
{
  const Constrained<2> body(cross(0.4, false), contact());
  auto const matrices =
    assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(), fourMaterials(body.mesh));
  Vector x(body.dofs.owned()), y(body.dofs.owned());
  for (auto* vector : {&x, &y}) {
    auto const values = vector->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      for (int c = 0; c < 2; ++c) {
        values(body.dofs.dof(node, c), 0) =
          pseudorandom(2 * body.mesh.global_ids[node] + c, vector == &x ? 5 : 6);
      }
    }
  }
  for (auto const& A : {matrices.mass, matrices.viscosity, matrices.stiffness}) {
    const double energy = product(*A, x)->dot(x);
    EXPECT_GT(energy, 0);
    EXPECT_NEAR(product(*A, x)->dot(y), product(*A, y)->dot(x), 1e-12 * energy);
  }
}

TEST(CrossingFaults, GiveBackTheVectorsAtTheirVertices)
{
  auto const whole = cross(0.4, false);
  const auto values = valuesAt(whole);
  const Constrained<2> body(whole, contact());
  const auto value = [&](int vertex) { return values[body.mesh.global_ids[vertex]]; };
  auto const vectors = alongAxes(body.constraints.frames(), body.dofs, *unknowns(body, value));
  for (int vertex = 0; vertex < body.mesh.num_owned; ++vertex) {
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(vectors[2 * vertex + d], value(vertex)[d], 1e-15);
    }
  }
}

TEST(CrossingFaults, SlipButDoNotOpen)
{
  const double angle = 0.4;
  const Constrained<2> body(cross(angle, false), contact());
  const Eigen::Vector2d along_level(std::cos(angle), std::sin(angle));
  if (auto const crossing = ownedCrossing(body.mesh)) {
    for (int c : {0, 1}) {
      EXPECT_FALSE(body.fixed(crossing->mean, c)) << "the mean is free";
      EXPECT_TRUE(body.fixed(crossing->both, c)) << "what is no slip is held";
    }
    std::set<int> faults;
    for (int plus : crossing->plus) {
      EXPECT_FALSE(body.fixed(plus, 0)) << "along the fault";
      EXPECT_TRUE(body.fixed(plus, 1)) << "across it";
      const double along = std::abs(body.row(plus, 0).dot(along_level));
      EXPECT_NEAR(along, std::round(along), 1e-14) << "along one of the two";
      faults.insert(along > 0.5 ? 0 : 1);
    }
    EXPECT_EQ(faults.size(), 2u) << "one for each fault";
  }
  EXPECT_EQ(sumOverRanks(ownedCrossing(body.mesh) ? 1 : 0), 1);
}

// Four blocks that move along the two faults: no force, and the unknowns that are held are zero.
TEST(CrossingFaults, SlideInFourBlocksWithoutForce)
{
  for (double angle : {0., 0.4, 1.3}) {
    const Constrained<2> body(cross(angle), contact());
    auto const materials = fourMaterials(body.mesh, angle);
    auto const matrices =
      assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(), materials);
    // The quadrant of a vertex is that of its cells. A rank has all cells of its own vertices.
    std::vector<Point<2>> centres(body.mesh.vertices.size());
    for (auto const& cell : body.mesh.cells) {
      for (int vertex : cell) {
        for (int d = 0; d < 2; ++d) {
          centres[vertex][d] = (body.mesh.vertices[cell[0]][d] + body.mesh.vertices[cell[1]][d] +
                                body.mesh.vertices[cell[2]][d]) /
                               3;
        }
      }
    }
    const double c = std::cos(angle), s = std::sin(angle);
    const auto x = unknowns(body, [&](int vertex) {
      auto const& centre = centres[vertex];
      const double upper = c * centre[1] - s * centre[0] > 1 ? 1 : -1,
                   right = c * centre[0] + s * centre[1] > 1.5 ? 1 : -1;
      const double level = 0.7 + 2 * upper / 2, upright = -0.3 + 5 * right / 2;
      return Point<2>{c * level - s * upright, s * level + c * upright};
    });
    auto const values = x->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (int node = 0; node < body.mesh.num_owned; ++node) {
      for (int k : {0, 1}) {
        if (body.fixed(node, k)) {
          EXPECT_NEAR(values(body.dofs.dof(node, k), 0), 0, 1e-14);
        }
      }
    }
    EXPECT_LT(product(*matrices.stiffness, *x)->normInf(), roundingOf(*matrices.stiffness, *x));
    EXPECT_GT(x->norm2(), 1);
    auto const rigid = rigidBodyMotions(body.mesh, body.dofs, body.constraints.frames());
    MultiVector forces(matrices.stiffness->getRangeMap(), rigid->getNumVectors());
    matrices.stiffness->apply(*rigid, forces);
    for (std::size_t k = 0; k < rigid->getNumVectors(); ++k) {
      EXPECT_LT(forces.getVector(k)->normInf(),
                roundingOf(*matrices.stiffness, *rigid->getVector(k)));
    }
  }
  const Constrained<2> body(cross(), contact());
  EXPECT_EQ(bodyPieces(body.mesh, worldCommunicator()).num_pieces, 1);
  EXPECT_EQ(bodyPieces(body.mesh, worldCommunicator()).num_pinched, 0);
}

TEST(CrossingFaults, HaveTwoNodesAtTheCrossing)
{
  Constrained<2> body(cross(0, false), contact());
  auto const materials = fourMaterials(body.mesh);
  auto const matrices = assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(), materials);
  auto const surface = surfaceOf(body, matrices);
  EXPECT_EQ(surface->numGlobalNodes(), 5 + 3);
  EXPECT_NEAR(surface->totalWeight(), 2 + 1, 1e-14);
  EXPECT_EQ(surface->numSliding(), 3 + 1) << "not at the four tips";
  auto const beside = materialsAtNodes(body.mesh, *surface, materials);
  std::vector<int> there;
  for (int node = 0; node < surface->numNodes(); ++node) {
    auto const& of_node = (*surface)[node];
    if (std::abs(of_node.place[0] - 1.5) > off || std::abs(of_node.place[1] - 1) > off) {
      EXPECT_EQ(of_node.copies.size(), 2u);
      continue;
    }
    there.push_back(node);
    EXPECT_EQ(of_node.copies.size(), 4u);
    EXPECT_EQ(std::set<int>(of_node.copies.begin(), of_node.copies.end()).size(), 4u);
    const bool is_level = std::abs(of_node.normal[1]) > 0.5;
    // The facets of each fault alone: 1/2 on either side of the other fault.
    EXPECT_NEAR(of_node.weight, 0.5, 1e-14);
    EXPECT_NEAR(of_node.normal[is_level ? 1 : 0], -1, 1e-14) << "out of the plus side";
    EXPECT_NEAR(of_node.tangents[0][is_level ? 0 : 1], 1, 1e-14);
    // In series over each fault, of the mean along it: (1 + 4) / 2 above and (2 + 8) / 2 below.
    const double one = is_level ? 2.5 : 1.5, other = is_level ? 5 : 6;
    EXPECT_NEAR(beside[node].shear_modulus, 2e4 * 2 / (1 / one + 1 / other), 1e-9);
  }
  EXPECT_EQ(sumOverRanks(static_cast<int>(there.size())), 2);
  if (there.size() == 2) { // one rank owns both
    EXPECT_GT(std::abs((*surface)[there[0]].normal[0] - (*surface)[there[1]].normal[0]), 0.5);
    for (auto const& colour : surface->colours()) {
      auto const nodes = toHost(colour);
      int found = 0;
      for (std::size_t k = 0; k < nodes.extent(0); ++k) {
        found += nodes(k) == there[0] || nodes(k) == there[1] ? 1 : 0;
      }
      EXPECT_LT(found, 2) << "they are neighbours";
    }
  }
}

// Two names that are one fault at the crossing share its node: all is as with one name.
TEST(CrossingFaults, OfNamesThatContinueEachOther)
{
  const auto along = [](auto const& is_there) {
    return [=](Point<2> const& x) { return std::abs(x[1] - 1) < off && is_there(x[0]); };
  };
  auto whole = uniformRectangle(6, 4, size_x, size_y);
  mesh::addFaults<2>(whole, {{"east", along([](double x) { return x > 1.5 - off; })},
                             {"upright", [](auto& x) { return std::abs(x[0] - 1.5) < off; }},
                             {"west", along([](double x) { return x < 1.5 + off; })}});
  mesh::splitFaults(whole, "test");
  const Boundaries level = {"east", "west"};
  Constrained<2> body(whole, {{"East", "east", ContactAcrossFault{level}},
                              {"Upright", "upright", ContactAcrossFault{{"upright"}}},
                              {"West", "west", ContactAcrossFault{level}}});
  Constrained<2> expected(cross(), contact());
  const auto surface_of = [](Constrained<2>& one, std::vector<std::string> const& names) {
    auto const matrices =
      assembleBody<2>(one.mesh, one.dofs, one.constraints.frames(), fourMaterials(one.mesh));
    return makeFaultSurface(one.mesh, mesh::joinBoundaries(one.mesh, names), one.constraints,
                            one.dofs, *matrices.stiffness->getCrsGraph(), OtherSide::body);
  };
  auto const surface = surface_of(body, {"east", "upright", "west"}),
             reference = surface_of(expected, {"level", "upright"});
  ASSERT_EQ(surface->numNodes(), reference->numNodes());
  EXPECT_EQ(surface->numSliding(), reference->numSliding());
  for (int node = 0; node < surface->numNodes(); ++node) {
    auto const &one = (*surface)[node], &other = (*reference)[node];
    EXPECT_EQ(one.copies, other.copies);
    EXPECT_EQ(one.dofs, other.dofs);
    EXPECT_NEAR(one.weight, other.weight, 1e-14);
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(one.normal[d], other.normal[d], 1e-14);
      EXPECT_NEAR(one.tangents[0][d], other.tangents[0][d], 1e-14);
    }
  }
}

// In a body under uniform stress each node bears the traction of its own facets.
TEST(CrossingFaults, BearTheNormalStressOfEach)
{
  Constrained<2> body(cross(0, false), contact());
  const Material rock{900, 5e4, 2e4, 0, 0};
  auto const matrices = assembleBody<2>(body.mesh, body.dofs, body.constraints.frames(),
                                        std::vector<Material>(body.mesh.cells.size(), rock));
  auto const surface = surfaceOf(body, matrices);
  const double xx = 3e-3, yy = -2e-3, xy = 1e-3; // strain
  const auto x = unknowns(body, [&](int vertex) {
    auto const& place = body.mesh.vertices[vertex];
    return Point<2>{xx * place[0] + 2 * xy * place[1], yy * place[1]};
  });
  auto const force = product(*matrices.stiffness, *x);
  auto const forces = force->getLocalViewHost(Tpetra::Access::ReadOnly);
  const double lame = rock.bulk_modulus - 2. / 3 * rock.shear_modulus;
  const double stress_xx = lame * (xx + yy) + 2 * rock.shear_modulus * xx,
               stress_yy = lame * (xx + yy) + 2 * rock.shear_modulus * yy,
               stress_xy = 2 * rock.shear_modulus * xy;
  int num_nodes = 0;
  for (int node = 0; node < surface->numNodes(); ++node) {
    if (!surface->slides(node)) {
      continue;
    }
    auto const& of_node = (*surface)[node];
    const int vertex = surface->vertex(node);
    const bool is_level = std::abs(of_node.normal[1]) > 0.5;
    const double sign = body.row(vertex, is_level ? 1 : 0)[is_level ? 1 : 0] > 0 ? 1 : -1;
    const double weight = of_node.weight; // its normal points out of the plus side
    EXPECT_NEAR(sign * forces(body.dofs.dof(vertex, is_level ? 1 : 0), 0),
                -weight * (is_level ? stress_yy : stress_xx), 1e-9);
    EXPECT_NEAR(forces(of_node.dofs[0], 0), -weight * stress_xy, 1e-9);
    ++num_nodes;
  }
  EXPECT_EQ(sumOverRanks(num_nodes), 4);
}
} // namespace asperity::fem
