#include "fem/inelastic/InelasticCells.hpp"

#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/BodyMatrices.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

// Cells that yield, on any number of ranks.
namespace asperity::fem
{
using namespace testing;

namespace
{
constexpr Material material = {900, 7e4, 3e4, 0, 0};

template <int Dim>
GlobalMesh<Dim> wholeMesh()
{
  if constexpr (Dim == 2) {
    return uniformRectangle(5, 4, 2, 1);
  } else {
    return uniformCube(2);
  }
}

// Every other cell of a mesh may yield.
template <int Dim>
struct Sample
{
  explicit Sample(int components, double strength = 1)
      : mesh(distributed())
      , dofs(std::make_shared<DofMap>(mesh.global_ids, mesh.num_owned, components,
                                      worldCommunicator()))
      , frames(static_cast<int>(mesh.vertices.size()), components)
      , cells(mesh, dofs, frames, std::vector<Material>(mesh.cells.size(), material),
              rock(components, strength))
  {
  }

  static Mesh<Dim> distributed()
  {
    auto whole = wholeMesh<Dim>();
    distort(whole, 0.02);
    return mesh::distribute(whole, *worldCommunicator());
  }

  bool yields(int cell) const
  {
    GlobalOrdinal sum = 0;
    for (const int vertex : mesh.cells[cell]) {
      sum += mesh.global_ids[vertex];
    }
    return sum % 2 == 0;
  }

  YieldingRock rock(int components, double strength) const
  {
    YieldingRock result;
    result.parts.push_back({bulkLaws().at("Von Mises"), {}, {}});
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
      if (yields(cell)) {
        auto& part = result.parts.front();
        part.cells.push_back(cell);
        part.parameters.insert(part.parameters.end(), {strength, 0., 0., 1., 1.});
      }
    }
    result.initial_stress.resize(mesh.cells.size() * numTensorComponents(components));
    result.initial_mean.resize(mesh.cells.size());
    return result;
  }

  // A displacement that depends on the place alone.
  RCP<Vector> motion(int sequence) const
  {
    auto const u = rcp(new Vector(dofs->owned()));
    auto const values = u->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < mesh.num_owned; ++node) {
      for (int c = 0; c < dofs->components(); ++c) {
        values(dofs->dof(node, c), 0) =
          1e-3 * pseudorandom(mesh.global_ids[node] * dofs->components() + c, sequence);
      }
    }
    return u;
  }

  Mesh<Dim> mesh;
  std::shared_ptr<const DofMap> dofs;
  NodalFrames frames;
  InelasticCells cells;
};

template <int Dim>
void expectSharedOnce(int components)
{
  const Sample<Dim> sample(components);
  auto const& sharing = sample.cells.sharing();
  auto numbers = gatherToAll(
    std::vector<double>(sharing.numbers().begin(), sharing.numbers().end()), *worldCommunicator());
  std::sort(numbers.begin(), numbers.end());
  std::vector<double> all(numbers.size());
  std::iota(all.begin(), all.end(), 0.);
  EXPECT_EQ(numbers, all);
  const auto mine = static_cast<int>(
    std::count_if(sample.mesh.cells.begin(), sample.mesh.cells.end(), [&](auto const& cell) {
      return sample.yields(static_cast<int>(&cell - &sample.mesh.cells[0]));
    }));
  EXPECT_EQ(static_cast<int>(sharing.cells().size()), mine);

  // Copies of a cell agree bit for bit, before any exchange.
  auto const before = sample.cells.none(), after = sample.cells.none();
  sample.cells.respond(*sample.motion(1), 1, before, after);
  auto const found = toHost(after.strain);
  const TensorView copy("copy", found.extent(0), found.extent(1));
  auto const own = Kokkos::create_mirror_view(copy);
  for (int row = 0; row < sharing.numOwned(); ++row) {
    for (int k = 0; k < found.extent_int(1); ++k) {
      own(row, k) = found(row, k);
    }
  }
  Kokkos::deep_copy(copy, own);
  sharing.exchange(copy);
  auto const exchanged = toHost(copy);
  double largest = 0;
  for (int row = 0; row < sample.cells.numCells(); ++row) {
    for (int k = 0; k < found.extent_int(1); ++k) {
      EXPECT_EQ(exchanged(row, k), found(row, k));
      largest = std::max(largest, std::abs(found(row, k)));
    }
  }
  EXPECT_GT(maxOverRanks(largest, *worldCommunicator()), 1e-4);
}
} // namespace

TEST(InelasticCells, AreSharedByRanks)
{
  expectSharedOnce<2>(1);
  expectSharedOnce<2>(2);
  expectSharedOnce<3>(3);
}

// The whole deviatoric strain of all cells without strength is inelastic; the work of its forces in
// the same motion is twice the energy, and both are those of the deviatoric stiffness.
template <int Dim>
void expectForcesOfStiffness(int components)
{
  Sample<Dim> sample(components, 1e-200);
  auto const u = sample.motion(2), f = rcp(new Vector(sample.dofs->owned()));
  auto const before = sample.cells.none(), after = sample.cells.none();
  sample.cells.respond(*u, 1, before, after);
  sample.cells.addForces(after.strain, *f);

  // K of what yields: its shear modulus alone.
  std::vector<Material> materials(sample.mesh.cells.size());
  for (std::size_t cell = 0; cell < materials.size(); ++cell) {
    materials[cell].shear_modulus =
      sample.yields(static_cast<int>(cell)) ? material.shear_modulus : 0;
  }
  auto const K = assembleBody<Dim>(sample.mesh, *sample.dofs, sample.frames, materials).stiffness;
  Vector expected(sample.dofs->owned());
  K->apply(*u, expected);
  const double size = expected.norm2();
  EXPECT_NEAR(sample.cells.energy(after.strain), u->dot(*f) / 2, 1e-12 * size);
  expected.update(-1, *f, 1);
  EXPECT_LE(expected.norm2(), 1e-12 * size);
  EXPECT_GT(size, 0.1);
}

TEST(InelasticCells, HaveTheForcesOfTheDeviatoricStiffness)
{
  expectForcesOfStiffness<2>(1);
  expectForcesOfStiffness<2>(2);
  expectForcesOfStiffness<3>(3);
}
} // namespace asperity::fem
