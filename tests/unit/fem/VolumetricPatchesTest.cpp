#include "fem/BodyMatrices.hpp"

#include "base/parallel/Reductions.hpp"
#include "fem/Simplex.hpp"
#include "fem/stress/CellStress.hpp"
#include "mesh/parallel/CellGroups.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Eigen/Dense>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

// Patches of cells that share a volumetric strain: which cells they have on any number of ranks,
// and the stiffness and the stress that follow from them.
namespace asperity::fem
{
using namespace fem::test;

namespace
{
constexpr double shear = 2e4;

template <int Dim>
GlobalMesh<Dim> wholeMesh()
{
  auto whole = [] {
    if constexpr (Dim == 2) {
      return uniformRectangle(6, 5, 1, 1);
    } else {
      return uniformCube(3);
    }
  }();
  distort(whole, 0.05);
  whole.region_names = {"left", "right"};
  for (std::size_t cell = 0; cell < whole.cells.size(); ++cell) {
    whole.cell_regions[cell] =
      mesh::centroid(mesh::corners(whole, whole.cells[cell]))[0] < 0.5 ? 0 : 1;
  }
  return whole;
}

// A nearly incompressible body on some ranks; on the right its moduli are three times as large.
template <int Dim>
struct Rock
{
  explicit Rock(RCP<const Communicator> const& comm, double own_ratio = own_poissons_ratio)
      : communicator(comm)
      , mesh(mesh::distribute(wholeMesh<Dim>(), *comm))
  {
    mesh::completeGroups(mesh, patchVertices(mesh, faults, *comm), *comm);
    std::vector<double> own;
    for (const int region : mesh.cell_regions) {
      const double factor = region == 0 ? 1 : 3;
      materials.push_back({1000, 100 * factor * shear, factor * shear, 0, 0});
      own.push_back(ownModulus(materials.back(), own_ratio));
    }
    vertices = patchVertices(mesh, faults, *comm);
    patches = makeVolumetricPatches(mesh, vertices, materials, own);
    dofs = std::make_unique<DofMap>(mesh.global_ids, mesh.num_owned, Dim, comm);
    stiffness = stiffnessWith(patches);
  }

  RCP<const CrsMatrix> stiffnessWith(VolumetricPatches const& with) const
  {
    const NodalFrames frames(dofs->numLocalNodes(), Dim);
    return assembleBody<Dim>(mesh, *dofs, frames, materials, {}, with).stiffness;
  }

  // With value(vertex, component) at the owned dofs.
  template <class Value>
  Vector vector(Value const& value) const
  {
    Vector x(dofs->owned());
    auto const view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int v = 0; v < mesh.num_owned; ++v) {
      for (int c = 0; c < Dim; ++c) {
        view(dofs->dof(v, c), 0) = value(v, c);
      }
    }
    return x;
  }

  Vector random(int sequence) const
  {
    return vector(
      [&](int v, int c) { return pseudorandom(Dim * mesh.global_ids[v] + c, sequence); });
  }

  Vector linear(int sequence) const
  {
    return vector([&](int v, int c) {
      double sum = 0;
      for (int k = 0; k < Dim; ++k) {
        sum += pseudorandom(Dim * c + k, sequence) * mesh.vertices[v][k];
      }
      return sum;
    });
  }

  // Values at local vertices, (vertices, Dim).
  std::vector<double> at(Vector const& x, std::vector<int> const& where) const
  {
    Vector local(dofs->overlap());
    dofs->shareWithGhosts(x, local);
    auto const view = local.getLocalViewHost(Tpetra::Access::ReadOnly);
    std::vector<double> values;
    for (const int v : where) {
      for (int c = 0; c < Dim; ++c) {
        values.push_back(view(dofs->dof(v, c), 0));
      }
    }
    return values;
  }

  RCP<const Communicator> communicator;
  std::vector<std::string> faults = {"top"};
  Mesh<Dim> mesh;
  std::vector<Material> materials;
  std::vector<int> vertices;
  VolumetricPatches patches;
  std::unique_ptr<DofMap> dofs;
  RCP<const CrsMatrix> stiffness;
};

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

// The ids of the vertices of each of a patch's cells, sorted.
template <int Dim>
using Cells = std::set<std::vector<GlobalOrdinal>>;

template <int Dim>
Cells<Dim> cellsOf(Mesh<Dim> const& mesh, VolumetricPatches::Patch const& patch)
{
  Cells<Dim> cells;
  for (const int cell : patch.cells) {
    std::vector<GlobalOrdinal> ids;
    for (const int v : mesh.cells[cell]) {
      ids.push_back(mesh.global_ids[v]);
    }
    std::sort(ids.begin(), ids.end());
    cells.insert(ids);
  }
  return cells;
}

// The forces of the stress of volume and shear in the cells of a whole body, by the definition of
// the patches' energy, (vertices, Dim).
template <int Dim>
std::vector<double> forcesByDefinition(Rock<Dim> const& rock, std::vector<double> const& u)
{
  auto const& mesh = rock.mesh;
  std::vector<Eigen::Matrix<double, Dim, Dim>> strains;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    auto const simplex = simplexOf(mesh, static_cast<int>(c));
    Eigen::Matrix<double, Dim, Dim> gradient = Eigen::Matrix<double, Dim, Dim>::Zero();
    for (int corner = 0; corner <= Dim; ++corner) {
      for (int i = 0; i < Dim; ++i) {
        for (int k = 0; k < Dim; ++k) {
          gradient(i, k) += u[Dim * mesh.cells[c][corner] + i] * simplex.gradients[corner][k];
        }
      }
    }
    strains.push_back((gradient + gradient.transpose()) / 2);
  }
  std::vector<double> forces(u.size(), 0);
  const double own_share = 2 * (1 + own_poissons_ratio) / (3 * (1 - 2 * own_poissons_ratio));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    // The patch of the cell: those with the same vertex in the same region.
    double measure = 0, mean = 0;
    for (std::size_t other = 0; other < mesh.cells.size(); ++other) {
      if (rock.vertices[other] == rock.vertices[c] &&
          mesh.cell_regions[other] == mesh.cell_regions[c]) {
        const double of_other = simplexOf(mesh, static_cast<int>(other)).measure;
        measure += of_other;
        mean += of_other * strains[other].trace();
      }
    }
    mean /= measure;
    auto const& m = rock.materials[c];
    const double k = own_share * m.shear_modulus;
    const double volume =
      (k - 2. / 3 * m.shear_modulus) * strains[c].trace() + (m.bulk_modulus - k) * mean;
    const Eigen::Matrix<double, Dim, Dim> stress =
      volume * Eigen::Matrix<double, Dim, Dim>::Identity() + 2 * m.shear_modulus * strains[c];
    auto const simplex = simplexOf(mesh, static_cast<int>(c));
    for (int corner = 0; corner <= Dim; ++corner) {
      const Eigen::Matrix<double, Dim, 1> force =
        simplex.measure * stress *
        Eigen::Map<const Eigen::Matrix<double, Dim, 1>>(simplex.gradients[corner].data());
      for (int i = 0; i < Dim; ++i) {
        forces[Dim * mesh.cells[c][corner] + i] += force[i];
      }
    }
  }
  return forces;
}

template <class Dimension>
class VolumetricPatchesTest : public ::testing::Test
{
};

template <int D>
using Dimension = std::integral_constant<int, D>;
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(VolumetricPatchesTest, Dimensions);
} // namespace

TYPED_TEST(VolumetricPatchesTest, HaveTheSameCellsOnAnyNumberOfRanks)
{
  constexpr int Dim = TypeParam::value;
  const Rock<Dim> whole(selfCommunicator());
  const Rock<Dim> part(worldCommunicator());
  std::set<Cells<Dim>> of_whole, of_part;
  for (auto const& patch : whole.patches.patches) {
    of_whole.insert(cellsOf(whole.mesh, patch));
  }
  for (auto const& patch : part.patches.patches) {
    of_part.insert(cellsOf(part.mesh, patch));
  }
  EXPECT_LE(of_whole.size(), whole.mesh.vertices.size());
  EXPECT_TRUE(std::includes(of_whole.begin(), of_whole.end(), of_part.begin(), of_part.end()));
  // All patches around an owned vertex are there.
  std::set<Cells<Dim>> around;
  for (auto const& patch : whole.patches.patches) {
    const bool touches = std::any_of(patch.cells.begin(), patch.cells.end(), [&](int cell) {
      auto const& corners = whole.mesh.cells[cell];
      return std::any_of(corners.begin(), corners.end(), [&](int v) {
        auto const end = part.mesh.global_ids.begin() + part.mesh.num_owned;
        return std::find(part.mesh.global_ids.begin(), end, v) != end;
      });
    });
    if (touches) {
      around.insert(cellsOf(whole.mesh, patch));
    }
  }
  EXPECT_TRUE(std::includes(of_part.begin(), of_part.end(), around.begin(), around.end()));
}

TYPED_TEST(VolumetricPatchesTest, HaveOneVertexAndOneRegion)
{
  constexpr int Dim = TypeParam::value;
  const Rock<Dim> rock(worldCommunicator());
  std::vector<int> times_used(rock.mesh.cells.size(), 0);
  for (auto const& patch : rock.patches.patches) {
    EXPECT_GE(patch.cells.size(), 2U);
    for (const int cell : patch.cells) {
      ++times_used[cell];
      EXPECT_EQ(rock.vertices[cell], rock.vertices[patch.cells.front()]);
      EXPECT_EQ(rock.mesh.cell_regions[cell], rock.mesh.cell_regions[patch.cells.front()]);
    }
  }
  for (std::size_t cell = 0; cell < times_used.size(); ++cell) {
    EXPECT_EQ(times_used[cell], rock.patches.patch_of_cell[cell] < 0 ? 0 : 1);
  }
}

TYPED_TEST(VolumetricPatchesTest, AreNotThereUpToTheRatioThatCellsBearThemselves)
{
  constexpr int Dim = TypeParam::value;
  const Rock<Dim> rock(worldCommunicator(), 0.4999);
  EXPECT_TRUE(rock.patches.empty());
  const Material at_bound = {1000, 2 * shear * 1.3 / (3 * 0.4), shear, 0, 0};
  EXPECT_EQ(ownModulus(at_bound, own_poissons_ratio), at_bound.bulk_modulus);
}

TYPED_TEST(VolumetricPatchesTest, LeaveStressOfLinearDisplacementsAsItIs)
{
  constexpr int Dim = TypeParam::value;
  const Rock<Dim> rock(worldCommunicator());
  auto const of_cells = rock.stiffnessWith({});
  for (int sequence = 0; sequence < 3; ++sequence) {
    auto const u = rock.linear(sequence);
    EXPECT_LE(relativeDistance(times(*rock.stiffness, u), times(*of_cells, u)), 1e-12);
  }
}

TYPED_TEST(VolumetricPatchesTest, GiveTheForcesOfTheirEnergy)
{
  constexpr int Dim = TypeParam::value;
  const Rock<Dim> whole(selfCommunicator());
  const Rock<Dim> part(worldCommunicator());
  for (int sequence = 0; sequence < 2; ++sequence) {
    std::vector<int> all(whole.mesh.vertices.size());
    std::iota(all.begin(), all.end(), 0);
    auto const forces = forcesByDefinition(whole, whole.at(whole.random(sequence), all));
    auto const expected =
      part.vector([&](int v, int c) { return forces[Dim * part.mesh.global_ids[v] + c]; });
    EXPECT_LE(relativeDistance(times(*part.stiffness, part.random(sequence)), expected), 1e-12);
  }
}

TYPED_TEST(VolumetricPatchesTest, GiveTheStressThatBalancesTheForces)
{
  constexpr int Dim = TypeParam::value;
  const Rock<Dim> rock(worldCommunicator());
  std::vector<int> cells(rock.mesh.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  const CellStress<Dim> of_cells(rock.mesh, Dim, rock.materials, cells, {}, rock.patches);
  auto const u = rock.random(5);
  auto const stress = of_cells.stress(rock.at(u, of_cells.vertices()), {});
  auto const size = tensorComponents(Dim).size();
  std::vector<double> forces(Dim * rock.mesh.vertices.size(), 0);
  for (const int cell : cells) {
    auto const simplex = simplexOf(rock.mesh, cell);
    for (std::size_t k = 0; k < size; ++k) {
      auto const& name = tensorComponents(Dim)[k];
      const int i = name[0] - 'x', j = name[1] - 'x';
      for (int corner = 0; corner <= Dim && i < Dim; ++corner) {
        const double value = simplex.measure * stress[cell * size + k];
        const int v = rock.mesh.cells[cell][corner];
        forces[Dim * v + i] += value * simplex.gradients[corner][j];
        forces[Dim * v + j] += i == j ? 0 : value * simplex.gradients[corner][i];
      }
    }
  }
  auto const expected = rock.vector([&](int v, int c) { return forces[Dim * v + c]; });
  EXPECT_LE(relativeDistance(times(*rock.stiffness, u), expected), 1e-12);
}

// Also where patches have all of the bulk modulus.
TYPED_TEST(VolumetricPatchesTest, KeepStiffnessSymmetricAndPositive)
{
  constexpr int Dim = TypeParam::value;
  for (const double own_ratio : {own_poissons_ratio, -1.}) {
    const Rock<Dim> rock(selfCommunicator(), own_ratio);
    auto const matrix = rock.stiffness->getLocalMatrixHost();
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(matrix.numRows(), matrix.numRows());
    for (int row = 0; row < matrix.numRows(); ++row) {
      for (auto e = matrix.graph.row_map(row); e < matrix.graph.row_map(row + 1); ++e) {
        K(row, matrix.graph.entries(e)) = matrix.values(e);
      }
    }
    EXPECT_LE((K - K.transpose()).norm(), 1e-14 * K.norm());
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    constexpr int rigid_motions = Dim == 2 ? 3 : 6;
    EXPECT_LE(values.head(rigid_motions).cwiseAbs().maxCoeff(), 1e-12 * values.maxCoeff());
    EXPECT_GE(values[rigid_motions], 1e-2 * shear * (Dim == 2 ? 1 : 1. / 3));
  }
}
} // namespace asperity::fem
