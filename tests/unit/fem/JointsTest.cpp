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

// A branch that ends along a line at a fault that goes on, in space: one mean and the jump of the
// main fault at three vertices, and the jump over the branch along the line.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
using Condition3 = VelocityCondition<3>;
constexpr double off = 1e-9;
constexpr double wide = 1.5; // width of cells with x > 2, where those with x < 2 have 1

// Inside the body the facets of the main fault beside the line are 1.5 : 1 in area.
constexpr double share_inside = wide / (1 + wide);

Rotation turned() { return rotationAbout({1, -2, 3}, 0.7); }
Rotation unturned() { return rotationAbout({0, 0, 1}, 0); }

struct Model
{
  Rotation rotation = unturned();
  double from = 0;      // the branch begins at this z
  bool is_above = true; // the branch lies at y > 2, else at y < 2
  // Facets of the boundary `front` (z = 0) with their centroid there become `piece`.
  std::function<bool(double x, double y)> piece = nullptr;
};

// [0, 5] x [0, 4] x [0, 2] in cells of all shapes, with the fault `main` along y = 2 and `branch`
// along x = 2 on one side of it. Their line is parallel to z.
GlobalMesh<3> branched(Model const& model)
{
  auto mesh = uniformBox({4, 4, 4}, {4, 4, 2});
  mesh::addFaults<3>(mesh, {{"branch",
                             [&](auto& x) {
                               return std::abs(x[0] - 2) < off && x[2] > model.from - off &&
                                      (model.is_above ? x[1] > 2 - off : x[1] < 2 + off);
                             }},
                            {"main", [](auto& x) { return std::abs(x[1] - 2) < off; }}});
  distort(mesh, 0.1);
  for (auto& x : mesh.vertices) {
    x[0] += x[0] > 2 ? (wide - 1) * (x[0] - 2) : 0;
  }
  if (model.piece) {
    std::vector<GlobalMesh<3>::Facet> rest;
    for (auto const& facet : mesh.boundaries.at("front")) {
      const auto centre = mesh::centroid(mesh::corners(mesh, facet));
      (model.piece(centre[0], centre[1]) ? mesh.boundaries["piece"] : rest).push_back(facet);
    }
    mesh.boundaries["front"] = rest;
  }
  rotate(mesh, model.rotation);
  mesh::splitFaults(mesh, "test");
  return mesh;
}

std::vector<Condition3> contact()
{
  return {{"Branch", "branch", ContactAcrossFault{{"branch"}}},
          {"Main", "main", ContactAcrossFault{{"main"}}}};
}

auto constant(double value)
{
  return [value](auto const&, double) { return value; };
}

Material rock() { return {900, 5e4, 2e4, 10, 5}; }

// Another one in each of four quarters.
std::vector<Material> fourMaterials(Mesh<3> const& mesh, Rotation const& rotation)
{
  std::vector<Material> materials;
  for (auto const& cell : mesh.cells) {
    const auto x = rotatedBack(rotation, mesh::centroid(mesh::corners<3>(mesh.vertices, cell)));
    const double factor = (x[0] > 2 ? 1 : 2) * (x[1] > 2 ? 1 : 4);
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

// The joints that this rank owns, with the minus of the main fault.
struct OwnedJoint
{
  mesh::Joint joint;
  int mean;
  double share;
  double z; // of the place, before the rotation
};
std::vector<OwnedJoint> ownedJoints(Constrained<3> const& body, Rotation const& rotation)
{
  std::vector<OwnedJoint> result;
  auto const& terms = body.constraints.frames().vertexTerms();
  for (std::size_t i = 0; i < terms.joints().size(); ++i) {
    auto const& joint = terms.joints()[i];
    for (auto const& pair : body.mesh.splits) {
      if (joint.plus < body.mesh.num_owned && pair.plus == joint.main) {
        const auto place = rotatedBack(rotation, body.mesh.vertices[joint.plus]);
        result.push_back({joint, pair.minus, terms.share(i), place[2]});
      }
    }
  }
  return result;
}

int numFixed(Constrained<3> const& body, int node)
{
  return body.fixed(node, 0) + body.fixed(node, 1) + body.fixed(node, 2);
}

double dot(Point<3> const& a, std::array<double, 3> const& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
} // namespace

// Symmetric and exact: x' A x is that of bodies without common vertices, whose vertices move alike.
TEST(Joints, HaveTheEnergiesOfThreeBodies)
{
  for (const bool is_above : {true, false}) {
    auto const whole = branched({turned(), 0.5, is_above});
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
    std::vector<Point<3>> values;
    for (std::size_t v = 0; v < whole.vertices.size(); ++v) {
      const auto id = static_cast<GlobalOrdinal>(v);
      values.push_back({pseudorandom(id, 0), pseudorandom(id, 1), pseudorandom(id, 2)});
    }
    for (auto const& split : whole.splits) {
      if (split.is_tip) {
        values[split.plus] = values[split.minus];
      }
    }
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
    auto const vectors = alongAxes(body.constraints.frames(), body.dofs, *x);
    for (int vertex = 0; vertex < body.mesh.num_owned; ++vertex) {
      for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(vectors[3 * vertex + d], values[body.mesh.global_ids[vertex]][d], 1e-14);
      }
    }
  }
}

// Six dofs at three vertices: the mean, the slip of the main fault in its plane, and that of the
// branch along the line, where it lies in both planes. The line ends on the surface and, from
// z = 0.5 on, with a tip of the branch.
TEST(Joints, SlipAlongTheLineAndDoNotOpen)
{
  for (const double from : {0., 0.5}) {
    for (const bool is_above : {true, false}) {
      const Constrained<3> body(branched({turned(), from, is_above}), contact());
      const auto line = rotated(turned(), {0, 0, 1});
      const auto joints = ownedJoints(body, turned());
      for (auto const& [joint, mean, share, z] : joints) {
        EXPECT_EQ(numFixed(body, mean), 0);
        EXPECT_EQ(numFixed(body, joint.main), 1);
        EXPECT_EQ(numFixed(body, joint.plus), 2);
        EXPECT_FALSE(body.fixed(joint.plus, 0));
        double along = 0;
        for (int d = 0; d < 3; ++d) {
          along += body.row(joint.plus, 0)[d] * line[d];
        }
        EXPECT_NEAR(std::abs(along), 1, 1e-12);
      }
      EXPECT_EQ(sumOverRanks(static_cast<int>(joints.size())), from == 0 ? 5 : 3);
      for (auto const& pair : body.mesh.splits) {
        if (pair.is_tip && pair.plus < body.mesh.num_owned) {
          EXPECT_EQ(numFixed(body, pair.plus), 3);
        }
      }
    }
  }
}

// The motion of three rigid blocks: A beyond the main fault, B+ and B- on the plus and the minus
// side of the branch, with the slip D of the main fault in its plane and S along the line l:
//
//   v_A = c - D/2,  v_B+ = c + D/2 + S l/2,  v_B- = c + D/2 - S l/2.
//
// No fault opens: the jumps are S l over the branch, D + S l/2 over the main fault beside B+, and
// D - S l/2 beside B-; l lies in both faults, D in the main one. The slip of the main fault differs
// by S on the two sides of the line, so that its vertices there are independent along l.
// With v_B+ = m + d/2 + (1 - s) b, v_B- = m + d/2 - s b and v_A = m - d/2 the unknowns are
//
//   b = v_B+ - v_B- = S l,  d = s v_B+ + (1 - s) v_B- - v_A = D + (s - 1/2) S l,
//   m = (s v_B+ + (1 - s) v_B- + v_A)/2 = c + (s - 1/2) S l/2.
//
// So nothing that is held moves, and blocks without strain have no force.
TEST(Joints, SlideInThreeBlocksWithoutForce)
{
  const Point<3> c = {0.7, -0.2, 1.1}, D = {2, 0, -3};
  const double S = 5;
  for (auto const& rotation : {unturned(), turned()}) {
    for (const bool is_above : {true, false}) {
      const Constrained<3> body(branched({rotation, 0, is_above}), contact());
      auto const matrices = assembleBody<3>(body.mesh, body.dofs, body.constraints.frames(),
                                            fourMaterials(body.mesh, rotation));
      // The block of a vertex is that of its cells. A rank has all cells of its own vertices.
      std::vector<Point<3>> centres(body.mesh.vertices.size());
      for (auto const& cell : body.mesh.cells) {
        for (int vertex : cell) {
          centres[vertex] =
            rotatedBack(rotation, mesh::centroid(mesh::corners<3>(body.mesh.vertices, cell)));
        }
      }
      const auto x = unknowns(body, [&](int vertex) {
        const double side = centres[vertex][1] > 2 ? 0.5 : -0.5;
        const bool has_branch = (centres[vertex][1] > 2) == is_above;
        const double of_branch = !has_branch ? 0 : centres[vertex][0] > 2 ? 0.5 : -0.5;
        return rotated(
          rotation, {c[0] + side * D[0], c[1] + side * D[1], c[2] + side * D[2] + of_branch * S});
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
      for (auto const& [joint, mean, share, z] : ownedJoints(body, rotation)) {
        Point<3> jump{};
        double local[3] = {values(body.dofs.dof(joint.plus, 0), 0),
                           values(body.dofs.dof(joint.plus, 1), 0),
                           values(body.dofs.dof(joint.plus, 2), 0)};
        body.constraints.frames().fromFrame(joint.plus, local, jump.data());
        jump = rotatedBack(rotation, jump);
        EXPECT_NEAR(std::abs(jump[2]), S, 1e-13);
        if (rotation == unturned()) { // the plus sides are those of larger x and y
          EXPECT_NEAR(values(body.dofs.dof(joint.main, 0), 0), D[0], 1e-13);
          const double extra = (share - 0.5) * S * (is_above ? 1 : -1);
          EXPECT_NEAR(values(body.dofs.dof(joint.main, 2), 0), D[2] + extra, 1e-13);
        }
      }
    }
  }
}

TEST(Joints, KnowTheAreasBesideThem)
{
  for (const bool is_above : {true, false}) {
    const Constrained<3> body(branched({unturned(), 0, is_above}), contact());
    for (auto const& [joint, mean, share, z] : ownedJoints(body, unturned())) {
      EXPECT_EQ(joint.is_on_plus_side, is_above);
      if (z > off && z < 2 - off) {
        EXPECT_NEAR(share, share_inside, 1e-12);
      } else { // one triangle on one side, two on the other one
        const double one = wide / (wide + 2), two = 2 * wide / (2 * wide + 1);
        EXPECT_NEAR(std::min(std::abs(share - one), std::abs(share - two)), 0, 1e-12);
      }
    }
    // A ghost has the share that its owner knows.
    auto const& terms = body.constraints.frames().vertexTerms();
    for (std::size_t i = 0; i < terms.joints().size(); ++i) {
      const double z = body.mesh.vertices[terms.joints()[i].plus][2];
      if (z > off && z < 2 - off) {
        EXPECT_NEAR(terms.share(i), share_inside, 1e-12);
      }
    }
  }
}

// A uniform stress sigma: at each node of a fault inside the body the force across it is sigma n
// times the area of its own facets. At a joint, the parts of the main fault's facets in the force
// that belongs to b, (1 - s) f_B+ - s f_B-, are (1 - s) s A - s (1 - s) A = 0 times sigma n_main,
// where A is their area.
TEST(Joints, CarryTheTractionOfTheirOwnFacets)
{
  for (auto const& rotation : {unturned(), turned()}) {
    for (const bool is_above : {true, false}) {
      Constrained<3> body(branched({rotation, 0.5, is_above}), contact());
      const auto E = [](Point<3> const& x) {
        return Point<3>{2e-3 * x[0] + 1e-3 * x[1] - 4e-3 * x[2],
                        1e-3 * x[0] - 3e-3 * x[1] + 5e-3 * x[2],
                        -4e-3 * x[0] + 5e-3 * x[1] + 6e-3 * x[2]};
      };
      const double trace = 2e-3 - 3e-3 + 6e-3;
      const auto sigma = [&](Point<3> const& n) {
        auto result = E(n);
        for (int d = 0; d < 3; ++d) {
          result[d] = 2 * rock().shear_modulus * result[d] +
                      (rock().bulk_modulus - 2 * rock().shear_modulus / 3) * trace * n[d];
        }
        return result;
      };
      auto const matrices = assembleBody<3>(body.mesh, body.dofs, body.constraints.frames(),
                                            std::vector<Material>(body.mesh.cells.size(), rock()));
      const auto x = unknowns(body, [&](int v) { return E(body.mesh.vertices[v]); });
      const auto force = product(*matrices.stiffness, *x);
      auto const values = force->getLocalViewHost(Tpetra::Access::ReadOnly);
      const auto name = mesh::joinBoundaries(body.mesh, {"branch", "main"});
      auto const surface = makeFaultSurface(body.mesh, name, body.constraints, body.dofs,
                                            *matrices.stiffness->getCrsGraph(), OtherSide::body);
      int num_joints = 0;
      for (int i = 0; i < surface->numNodes(); ++i) {
        auto const& node = (*surface)[i];
        const auto place = rotatedBack(rotation, node.place);
        const bool is_inside = place[0] > off && place[0] < 2 + 2 * wide - off && place[1] > off &&
                               place[1] < 4 - off && place[2] > off && place[2] < 2 - off;
        if (!is_inside || !surface->slides(i)) {
          continue;
        }
        num_joints += std::abs(place[0] - 2) < off && std::abs(place[1] - 2) < off;
        for (int k : {0, 1, 2}) {
          const auto row = body.constraints.frames().row(surface->vertex(i), k);
          EXPECT_NEAR(values(body.dofs.dof(surface->vertex(i), k), 0),
                      node.weight * dot(sigma(node.normal), row), 1e-9);
        }
      }
      // z = 1 and 1.5: the branch and the main fault; z = 0.5: the main fault alone.
      EXPECT_EQ(sumOverRanks(num_joints), 2 * 2 + 1);
    }
  }
}

TEST(Joints, HaveANodeOfTheBranch)
{
  Constrained<3> body(branched({}), contact());
  auto const matrices = assembleBody<3>(body.mesh, body.dofs, body.constraints.frames(),
                                        fourMaterials(body.mesh, unturned()));
  const auto name = mesh::joinBoundaries(body.mesh, {"branch", "main"});
  auto const surface = makeFaultSurface(body.mesh, name, body.constraints, body.dofs,
                                        *matrices.stiffness->getCrsGraph(), OtherSide::body);
  EXPECT_EQ(surface->numGlobalNodes(), 25 + 15);
  EXPECT_EQ(surface->numSliding(), 25 + 15);
  EXPECT_NEAR(surface->totalWeight(), 2 * (2 + 2 * wide) + 2 * 2, 1e-12);
  int num_there = 0;
  double of_branch = 0;
  for (auto const& node : *surface) {
    const bool is_branch = std::abs(node.normal[0]) > 0.5;
    of_branch += is_branch ? node.weight : 0;
    const bool is_there = std::abs(node.place[0] - 2) < off && std::abs(node.place[1] - 2) < off;
    EXPECT_EQ(node.copies.size(), is_there && !is_branch ? 3u : 2u);
    num_there += is_there ? 1 : 0;
    if (is_there && is_branch) {
      const int node_number = surface->nodeAt(node.copies[0]);
      int num_free = 0;
      for (int k : {0, 1}) {
        if (!surface->held(node_number, k)) {
          ++num_free;
          EXPECT_NEAR(std::abs(node.tangents[k][2]), 1, 1e-12);
        }
      }
      EXPECT_EQ(num_free, 1);
    }
  }
  EXPECT_EQ(sumOverRanks(num_there), 2 * 5);
  EXPECT_NEAR(asperity::sumOverRanks(of_branch, *worldCommunicator()), 4, 1e-12);
}

// Where the line ends at a wall across it, the branch has no slip.
TEST(Joints, EndAtAWall)
{
  auto conditions = contact();
  conditions.push_back({"Wall", "front", SlidingWall{}});
  const Constrained<3> body(branched({}), conditions);
  int num_ends = 0;
  for (auto const& [joint, mean, share, z] : ownedJoints(body, unturned())) {
    if (z < off) {
      ++num_ends;
      EXPECT_EQ(numFixed(body, mean), 1);
      EXPECT_EQ(numFixed(body, joint.main), 2);
      EXPECT_EQ(numFixed(body, joint.plus), 3);
    }
  }
  EXPECT_EQ(sumOverRanks(num_ends), 1);
}

// The block beyond the branch is moved along the line by 1 m/s, the others are at rest.
TEST(Joints, AreMovedByTheirBlocks)
{
  const auto is_block = [](double x, double y) { return x > 2 && y > 2; };
  auto conditions = contact();
  conditions.push_back({"Rest", "front", PrescribedVelocity<3>{{0, 0, 1}, constant(0)}});
  conditions.push_back({"Block", "piece", PrescribedVelocity<3>{{0, 0, 1}, constant(1)}});
  const Constrained<3> body(branched({unturned(), 0, true, is_block}), conditions);
  for (auto const& [joint, mean, share, z] : ownedJoints(body, unturned())) {
    if (z < off) {
      EXPECT_NEAR(body.velocity(joint.plus, 0)[2], 1, 1e-14) << "slip of the branch";
      EXPECT_NEAR(body.velocity(joint.main, 0)[2], share, 1e-14) << "slip of the main fault";
      EXPECT_NEAR(body.velocity(mean, 0)[2], share / 2, 1e-14);
    }
  }
}

// A given slip rate of 2 m/s, at 45 degrees to the line, has a part along it.
TEST(Joints, TakeTheirPartOfAGivenSlip)
{
  for (auto const& rotation : {unturned(), turned()}) {
    const auto towards = rotated(rotation, {0, 1, 1});
    const std::vector<double> d(towards.begin(), towards.end());
    auto conditions = contact();
    conditions.push_back({"Rate", "branch", SlipTowards<3>{d, constant(2), {"branch"}}});
    conditions.push_back({"Rate", "branch", NoSlipSideways{d, {"branch"}}});
    const Constrained<3> body(branched({rotation}), conditions);
    for (auto const& [joint, mean, share, z] : ownedJoints(body, rotation)) {
      EXPECT_EQ(numFixed(body, joint.plus), 3);
      EXPECT_EQ(numFixed(body, joint.main), 1);
      const auto slip = body.velocity(joint.plus, 0);
      const auto found = rotatedBack(rotation, {slip[0], slip[1], slip[2]});
      EXPECT_NEAR(found[0], 0, 1e-13);
      EXPECT_NEAR(found[1], 0, 1e-13);
      EXPECT_NEAR(found[2], std::sqrt(2.), 1e-13);
    }
  }
}
} // namespace asperity::fem
