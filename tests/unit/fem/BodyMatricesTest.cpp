#include "fem/BodyMatrices.hpp"

#include "mesh/SimplexGeometry.hpp"
#include "portability/Renamed.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Eigen/Dense>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem
{
using namespace fem::test;

namespace
{
// A body of cells that each have another material, in the unit square or cube.
template <int DimOfMesh, int NumComponents>
struct Body
{
  static constexpr int Dim = DimOfMesh;
  static constexpr int Components = NumComponents;
  using Value = Eigen::Matrix<double, Components, 1>;
  using Gradient = Eigen::Matrix<double, Components, Dim>;

  Body()
      : mesh(mesh::distribute(wholeMesh(), *worldCommunicator()))
      , dofs(makeDofs(mesh, Components, worldCommunicator()))
  {
    for (auto const& cell : mesh.cells) {
      GlobalOrdinal id = 0;
      for (int v : cell) {
        id = 31 * id + mesh.global_ids[v];
      }
      auto const about = [id](double mean, int sequence) {
        return mean * (1 + 0.5 * pseudorandom(id % 10007, sequence));
      };
      materials.push_back(
        {about(1000, 0), about(3e4, 1), about(2e4, 2), about(50, 3), about(7, 4)});
    }
  }

  static auto wholeMesh()
  {
    if constexpr (Dim == 2) {
      auto whole = uniformRectangle(5, 4, 1, 1);
      distort(whole, 0.05);
      return whole;
    } else {
      auto whole = uniformCube(3);
      distort(whole, 0.05);
      return whole;
    }
  }

  NodalFrames axes() const { return NodalFrames(dofs.numLocalNodes(), Components); }

  // Another frame at every node, the same on every rank.
  NodalFrames turned() const
  {
    auto frames = axes();
    for (int node = 0; node < dofs.numLocalNodes() && Components > 1; ++node) {
      Eigen::Matrix<double, Components, Components> random;
      for (int k = 0; k < random.size(); ++k) {
        random.data()[k] = pseudorandom(mesh.global_ids[node], k);
      }
      const Eigen::HouseholderQR<decltype(random)> qr(random);
      const Eigen::Matrix<double, Components, Components, Eigen::RowMajor> q = qr.householderQ();
      NodalFrames::Matrix frame{};
      std::copy(q.data(), q.data() + q.size(), frame.begin());
      frames.set(node, frame);
    }
    return frames;
  }

  // The values of a function at the owned nodes, in these frames.
  template <class Function>
  Vector nodal(NodalFrames const& frames, Function const& function) const
  {
    Vector x(dofs.owned());
    auto const values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < dofs.numOwnedNodes(); ++node) {
      const Value along_axes = function(node);
      Value local;
      frames.toFrame(node, along_axes.data(), local.data());
      for (int c = 0; c < Components; ++c) {
        values(dofs.dof(node, c), 0) = local[c];
      }
    }
    return x;
  }

  Vector linear(Gradient const& gradient) const
  {
    return nodal(axes(), [&](int node) -> Value {
      return gradient * Eigen::Map<const Eigen::Matrix<double, Dim, 1>>(mesh.vertices[node].data());
    });
  }

  Vector random(NodalFrames const& frames, int sequence) const
  {
    return nodal(frames, [&](int node) {
      Value value;
      for (int c = 0; c < Components; ++c) {
        value[c] = pseudorandom(mesh.global_ids[node] * Components + c, sequence);
      }
      return value;
    });
  }

  Mesh<Dim> mesh;
  DofMap dofs;
  std::vector<Material> materials;
};

template <class Body>
auto assemble(Body const& body, NodalFrames const& frames)
{
  return assembleBody<Body::Dim>(body.mesh, body.dofs, frames, body.materials);
}

template <int Components, int Dim>
Eigen::Matrix<double, Components, Dim>
stressOf(Eigen::Matrix<double, Components, Dim> const& gradient, double bulk, double shear)
{
  if constexpr (Components == 1) {
    return shear * gradient;
  } else {
    const Eigen::Matrix<double, Dim, Dim> strain = (gradient + gradient.transpose()) / 2;
    return (bulk - 2. / 3 * shear) * strain.trace() * decltype(strain)::Identity() +
           2 * shear * strain;
  }
}

// The nodal forces of a stress that is constant in each cell, from the cells' faces alone: a face
// of area A with unit normal n gives each of its vertices A / Dim stress n.
template <class Body, class Stress>
Vector forcesOfFaces(Body const& body, Stress const& stress)
{
  constexpr int Dim = Body::Dim;
  std::vector<typename Body::Value> forces(body.dofs.numLocalNodes(), Body::Value::Zero());
  for (std::size_t c = 0; c < body.mesh.cells.size(); ++c) {
    for (int opposite = 0; opposite <= Dim; ++opposite) {
      std::array<int, Dim> face{};
      for (int k = 0, n = 0; k <= Dim; ++k) {
        if (k != opposite) {
          face[n++] = body.mesh.cells[c][k];
        }
      }
      auto const corners = mesh::corners<Dim>(body.mesh.vertices, face);
      auto const area = mesh::areaNormal(corners);
      auto const inward =
        mesh::difference<Dim>(body.mesh.vertices[body.mesh.cells[c][opposite]], corners[0]);
      Eigen::Matrix<double, Dim, 1> normal;
      for (int i = 0; i < Dim; ++i) {
        normal[i] = mesh::dot<Dim>(area, inward) > 0 ? -area[i] : area[i];
      }
      for (int v : face) {
        forces[v] += stress(body.materials[c]) * normal / Dim;
      }
    }
  }
  return body.nodal(body.axes(), [&](int node) { return forces[node]; });
}

Vector times(CrsMatrix const& matrix, Vector const& x)
{
  Vector y(matrix.getRangeMap());
  matrix.apply(x, y);
  return y;
}

double relativeDistance(Vector const& x, Vector const& expected)
{
  Vector difference(x, Teuchos::Copy);
  difference.update(-1, expected, 1);
  return difference.normInf() / expected.normInf();
}

// The vectors at the corners of a cell, one after the other, as a linear map of the unknowns of the
// whole mesh on this rank: the terms and frames of the corners.
template <class Body>
Eigen::MatrixXd unknownsToCorners(Body const& body, NodalFrames const& frames, int cell)
{
  constexpr int Components = Body::Components;
  Eigen::MatrixXd result =
    Eigen::MatrixXd::Zero((Body::Dim + 1) * Components, body.dofs.numLocalNodes() * Components);
  for (int i = 0; i <= Body::Dim; ++i) {
    for (auto const& [node, factor] : frames.terms(body.mesh.cells[cell][i])) {
      for (int c = 0; c < Components; ++c) {
        for (int k = 0; k < Components; ++k) {
          result(i * Components + c, body.dofs.dof(node, k)) += factor * frames.entry(node, k, c);
        }
      }
    }
  }
  return result;
}

// The gradients of a cell's basis functions, (Dim + 1) x Dim, from the inverse of its edges.
template <class Body>
Eigen::MatrixXd gradientsOf(Body const& body, int cell, double& measure)
{
  constexpr int Dim = Body::Dim;
  Eigen::Matrix<double, Dim, Dim> edges;
  for (int k = 0; k < Dim; ++k) {
    for (int i = 0; i < Dim; ++i) {
      edges(i, k) = body.mesh.vertices[body.mesh.cells[cell][k + 1]][i] -
                    body.mesh.vertices[body.mesh.cells[cell][0]][i];
    }
  }
  measure = edges.determinant() / (Dim == 2 ? 2 : 6);
  Eigen::MatrixXd result(Dim + 1, Dim);
  result.bottomRows(Dim) = edges.inverse();
  result.row(0) = -result.bottomRows(Dim).colwise().sum();
  return result;
}

// Mass, viscosity and stiffness on all local dofs, a sum of dense products over the cells: M, C, K
// of a cell are B'DB with the strains or gradients B of its basis functions.
template <class Body>
std::array<Eigen::MatrixXd, 3> sumsOverCells(Body const& body, NodalFrames const& frames)
{
  constexpr int Dim = Body::Dim;
  constexpr int Components = Body::Components;
  const int size = body.dofs.numLocalNodes() * Components;
  std::array<Eigen::MatrixXd, 3> sums;
  sums.fill(Eigen::MatrixXd::Zero(size, size));
  for (std::size_t cell = 0; cell < body.mesh.cells.size(); ++cell) {
    double measure = 0;
    auto const gradients = gradientsOf(body, static_cast<int>(cell), measure);
    auto const& m = body.materials[cell];
    constexpr int n = (Dim + 1) * Components;
    std::array<Eigen::MatrixXd, 3> local;
    local.fill(Eigen::MatrixXd::Zero(n, n));
    for (int a = 0; a < n; ++a) {
      for (int b = 0; b < n; ++b) {
        const int p = a / Components, i = a % Components, q = b / Components, j = b % Components;
        typename Body::Gradient of_a = Body::Gradient::Zero(), of_b = Body::Gradient::Zero();
        of_a.row(i) = gradients.row(p);
        of_b.row(j) = gradients.row(q);
        local[0](a, b) = i == j ? m.density * (p == q ? 2. : 1.) / ((Dim + 1) * (Dim + 2)) : 0;
        local[1](a, b) =
          of_a.cwiseProduct(stressOf(of_b, m.bulk_viscosity, m.shear_viscosity)).sum();
        local[2](a, b) = of_a.cwiseProduct(stressOf(of_b, m.bulk_modulus, m.shear_modulus)).sum();
      }
    }
    auto const T = unknownsToCorners(body, frames, static_cast<int>(cell));
    for (int k = 0; k < 3; ++k) {
      sums[k] += measure * T.transpose() * local[k] * T;
    }
  }
  return sums;
}

template <class Body>
class BodyMatricesTest : public ::testing::Test
{
protected:
  Body varied_body;
};

using Bodies = ::testing::Types<Body<2, 1>, Body<2, 2>, Body<3, 3>>;
TYPED_TEST_SUITE(BodyMatricesTest, Bodies);
} // namespace

TYPED_TEST(BodyMatricesTest, ConstantGradientsGiveTheForcesOfConstantStress)
{
  using Gradient = typename TypeParam::Gradient;
  auto const matrices = assemble(this->varied_body, this->varied_body.axes());
  for (int sample = 0; sample < 3; ++sample) {
    Gradient gradient;
    for (int k = 0; k < gradient.size(); ++k) {
      gradient.data()[k] = pseudorandom(k, sample);
    }
    auto const x = this->varied_body.linear(gradient);
    auto const elastic = forcesOfFaces(this->varied_body, [&](Material const& m) {
      return stressOf(gradient, m.bulk_modulus, m.shear_modulus);
    });
    EXPECT_LE(relativeDistance(times(*matrices.stiffness, x), elastic), 1e-13);
    auto const viscous = forcesOfFaces(this->varied_body, [&](Material const& m) {
      return stressOf(gradient, m.bulk_viscosity, m.shear_viscosity);
    });
    EXPECT_LE(relativeDistance(times(*matrices.viscosity, x), viscous), 1e-13);
  }
}

TYPED_TEST(BodyMatricesTest, RigidMotionsMeetNoResistance)
{
  using Value = typename TypeParam::Value;
  using Gradient = typename TypeParam::Gradient;
  auto const matrices = assemble(this->varied_body, this->varied_body.axes());
  std::vector<Vector> motions;
  for (int c = 0; c < TypeParam::Components; ++c) {
    motions.push_back(
      this->varied_body.nodal(this->varied_body.axes(), [c](int) { return Value::Unit(c); }));
    for (int d = 0; d < c; ++d) {
      Gradient spin = Gradient::Zero();
      spin(c, d) = 1;
      spin(d, c) = -1;
      motions.push_back(this->varied_body.linear(spin));
    }
  }
  for (auto const& motion : motions) {
    for (auto const& matrix : {matrices.stiffness, matrices.viscosity}) {
      EXPECT_LE(times(*matrix, motion).normInf(), 1e-13 * matrix->getFrobeniusNorm());
    }
  }
}

TYPED_TEST(BodyMatricesTest, MassIntegratesProductsOfLinearFunctions)
{
  using Gradient = typename TypeParam::Gradient;
  using Value = typename TypeParam::Value;
  auto& body = this->varied_body;
  const double density = 1234;
  for (auto& material : body.materials) {
    material.density = density;
  }
  auto const mass = assemble(body, body.axes()).mass;
  auto const entry = [&](int c, int axis) {
    Gradient gradient = Gradient::Zero();
    gradient(c, axis) = 1;
    return body.linear(gradient);
  };
  auto const product = [&](Vector const& x, Vector const& y) {
    return times(*mass, x).dot(y) / density;
  };
  for (int c = 0; c < TypeParam::Components; ++c) {
    auto const one = body.nodal(body.axes(), [c](int) { return Value::Unit(c); });
    EXPECT_NEAR(product(one, one), 1, 1e-14);
    EXPECT_NEAR(product(one, entry(c, 0)), 1. / 2, 1e-14);
    EXPECT_NEAR(product(entry(c, 1), entry(c, 1)), 1. / 3, 1e-14);
    EXPECT_NEAR(product(entry(c, 0), entry(c, 1)), 1. / 4, 1e-14);
    const int other = (c + 1) % TypeParam::Components;
    if (other != c) {
      EXPECT_NEAR(product(one, entry(other, 0)), 0, 1e-14);
    }
  }
}

TYPED_TEST(BodyMatricesTest, NodalFramesTurnTheMatricesAndNothingElse)
{
  auto const& body = this->varied_body;
  auto const frames = body.turned();
  auto const along_axes = assemble(body, body.axes());
  auto const turned = assemble(body, frames);
  for (auto matrix : {&BodyMatrices::mass, &BodyMatrices::viscosity, &BodyMatrices::stiffness}) {
    for (int sample = 0; sample < 2; ++sample) {
      auto const result = times(*(along_axes.*matrix), body.random(body.axes(), sample));
      auto const values = result.getLocalViewHost(Tpetra::Access::ReadOnly);
      auto const expected = body.nodal(frames, [&](int node) {
        typename TypeParam::Value value;
        for (int c = 0; c < TypeParam::Components; ++c) {
          value[c] = values(body.dofs.dof(node, c), 0);
        }
        return value;
      });
      EXPECT_LE(relativeDistance(times(*(turned.*matrix), body.random(frames, sample)), expected),
                1e-13);
    }
  }
}

// Each entry by itself: a wrong place of a block in the rows of the kernel would show here.
TYPED_TEST(BodyMatricesTest, EntriesAreSumsOverTheCells)
{
  auto const& body = this->varied_body;
  auto const frames = body.turned();
  auto const matrices = assemble(body, frames);
  auto const expected = sumsOverCells(body, frames);
  int k = 0;
  for (auto const& matrix : {matrices.mass, matrices.viscosity, matrices.stiffness}) {
    auto const rows = matrix->getLocalMatrixHost();
    Eigen::MatrixXd stored = Eigen::MatrixXd::Zero(rows.numRows(), expected[k].cols());
    for (int row = 0; row < rows.numRows(); ++row) {
      for (auto e = rows.graph.row_map(row); e < rows.graph.row_map(row + 1); ++e) {
        stored(row, rows.graph.entries(e)) = rows.values(e);
      }
    }
    EXPECT_LE((stored - expected[k].topRows(rows.numRows())).cwiseAbs().maxCoeff(),
              1e-13 * expected[k].cwiseAbs().maxCoeff());
    ++k;
  }
}

TYPED_TEST(BodyMatricesTest, GravityIsMassTimesAcceleration)
{
  using Value = typename TypeParam::Value;
  auto const& body = this->varied_body;
  auto const frames = body.turned();
  std::array<double, TypeParam::Components> acceleration{};
  for (int c = 0; c < TypeParam::Components; ++c) {
    acceleration[c] = 3 - 2 * c;
  }
  auto const g = body.nodal(frames, [&](int) { return Value(acceleration.data()); });
  auto const load = assembleGravity<TypeParam::Dim, TypeParam::Components>(
    body.mesh, body.dofs, frames, body.materials, acceleration);
  auto const mass = assemble(body, frames).mass;
  EXPECT_LE(relativeDistance(*load, times(*mass, g)), 1e-13);

  // The weight of the whole: each cell where its first vertex is owned.
  double mine = 0;
  for (std::size_t c = 0; c < body.mesh.cells.size(); ++c) {
    auto const corners = mesh::corners<TypeParam::Dim>(body.mesh.vertices, body.mesh.cells[c]);
    const bool counted = body.mesh.cells[c][0] < body.mesh.num_owned;
    mine += counted ? body.materials[c].density * mesh::signedMeasure(corners) : 0;
  }
  double total = 0;
  Teuchos::reduceAll(*worldCommunicator(), Teuchos::REDUCE_SUM, mine, Teuchos::outArg(total));
  EXPECT_NEAR(load->dot(g) / (total * Value(acceleration.data()).squaredNorm()), 1, 1e-13);
}

TYPED_TEST(BodyMatricesTest, CombinationsKeepOnlyTheDiagonalOfHeldDofs)
{
  auto const& body = this->varied_body;
  auto const matrices = assemble(body, body.turned());
  auto const& overlap = *body.dofs.overlap();
  std::vector<int> fixed(numLocalElements(overlap));
  for (int dof = 0; dof < static_cast<int>(fixed.size()); ++dof) {
    fixed[dof] = pseudorandom(overlap.getGlobalElement(dof), 9) > 0.2 ? 1 : 0;
  }
  auto const combined = combine(matrices, {2, 3, 5}, {fixed, 0});
  auto const rows = combined->getLocalMatrixHost();
  auto const m = matrices.mass->getLocalMatrixHost().values;
  auto const c = matrices.viscosity->getLocalMatrixHost().values;
  auto const k = matrices.stiffness->getLocalMatrixHost().values;
  int num_dropped = 0;
  for (int row = 0; row < rows.numRows(); ++row) {
    for (auto e = rows.graph.row_map(row); e < rows.graph.row_map(row + 1); ++e) {
      const int column = rows.graph.entries(e);
      const bool dropped = row != column && (fixed[row] || fixed[column]);
      num_dropped += dropped;
      EXPECT_DOUBLE_EQ(rows.values(e), dropped ? 0 : 2 * m(e) + 3 * c(e) + 5 * k(e));
    }
  }
  EXPECT_GT(num_dropped, 0);

  // On whole vectors: a free part that does not see the fixed one.
  auto x = body.random(body.axes(), 0);
  auto const before = times(*combined, x);
  {
    auto const values = x.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int row = 0; row < rows.numRows(); ++row) {
      values(row, 0) += fixed[row] ? 100 : 0;
    }
  }
  auto const after = times(*combined, x);
  auto const first = before.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const second = after.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int row = 0; row < rows.numRows(); ++row) {
    EXPECT_EQ(first(row, 0) == second(row, 0), !fixed[row]);
  }
}
} // namespace asperity::fem
