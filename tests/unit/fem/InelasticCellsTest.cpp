#include "fem/inelastic/InelasticCells.hpp"

#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/BodyMatrices.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

// Cells that yield, on any number of ranks.
namespace asperity::fem
{
using namespace fem::test;

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

struct Law
{
  char const* name;
  std::vector<double> parameters;
  double initial_mean; // stress [Pa]
};

Law vonMises(double strength) { return {"Von Mises", {strength, 0, 0, 1, 1, 0, 0}, 0}; }

// Every other cell of a mesh may yield.
template <int Dim>
struct Sample
{
  Sample(int components, Law const& law)
      : mesh(distributed())
      , dofs(std::make_shared<DofMap>(mesh.global_ids, mesh.num_owned, components,
                                      worldCommunicator()))
      , frames(static_cast<int>(mesh.vertices.size()), components)
      , cells(mesh, dofs, frames, std::vector<Material>(mesh.cells.size(), material),
              rock(components, law))
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

  YieldingRock rock(int components, Law const& law) const
  {
    YieldingRock result;
    result.parts.push_back({bulkLaws().at(law.name), {}, {}});
    auto values = law.parameters;
    auto completed = material;
    result.parts.front().law.complete(values.data(), completed);
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
      if (yields(cell)) {
        auto& part = result.parts.front();
        part.cells.push_back(cell);
        part.parameters.insert(part.parameters.end(), values.begin(), values.end());
      }
    }
    result.initial_stress.resize(mesh.cells.size() * numTensorComponents(components));
    result.initial_mean.resize(mesh.cells.size(), law.initial_mean);
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
  const Sample<Dim> sample(components, vonMises(1));
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
  auto const rows = sharing.rowsOfMesh(sample.mesh.cells.size());
  for (std::size_t cell = 0; cell < rows.size(); ++cell) {
    ASSERT_EQ(rows[cell] >= 0, sample.yields(static_cast<int>(cell)));
    EXPECT_TRUE(rows[cell] < 0 || sharing.cells()[rows[cell]] == static_cast<int>(cell));
  }

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

TensorView differenceOf(ConstTensorView const& a, ConstTensorView const& b)
{
  const TensorView result("difference", a.extent(0), a.extent(1));
  auto const host = Kokkos::create_mirror_view(result);
  auto const of_a = toHost(a), of_b = toHost(b);
  for (int row = 0; row < a.extent_int(0); ++row) {
    for (int k = 0; k < a.extent_int(1); ++k) {
      host(row, k) = of_a(row, k) - of_b(row, k);
    }
  }
  Kokkos::deep_copy(result, host);
  return result;
}

// Where the stress of cells does not depend on the motion, half the difference of the inelastic
// strains in two opposite motions is the strain. The work of its forces in the motion is twice the
// energy, and both are those of the stiffness.
template <int Dim>
void expectForcesOfStiffness(int components, Law const& law, double bulk_modulus)
{
  Sample<Dim> sample(components, law);
  auto const u = sample.motion(2), opposite = sample.motion(2),
             f = rcp(new Vector(sample.dofs->owned()));
  opposite->scale(-1);
  auto const before = sample.cells.none(), after = sample.cells.none(), other = sample.cells.none();
  sample.cells.respond(*u, 1, before, after);
  sample.cells.respond(*opposite, 1, before, other);
  auto const twice = differenceOf(after.strain, other.strain);
  sample.cells.addForces(twice, *f);
  f->scale(0.5);

  // K of what yields: these moduli alone.
  std::vector<Material> materials(sample.mesh.cells.size());
  for (std::size_t cell = 0; cell < materials.size(); ++cell) {
    if (sample.yields(static_cast<int>(cell))) {
      materials[cell].shear_modulus = material.shear_modulus;
      materials[cell].bulk_modulus = bulk_modulus;
    }
  }
  auto const K = assembleBody<Dim>(sample.mesh, *sample.dofs, sample.frames, materials).stiffness;
  Vector expected(sample.dofs->owned());
  K->apply(*u, expected);
  const double size = expected.norm2();
  EXPECT_NEAR(sample.cells.energy(twice) / 4, u->dot(*f) / 2, 1e-12 * size);
  expected.update(-1, *f, 1);
  EXPECT_LE(expected.norm2(), 1e-12 * size);
  EXPECT_GT(size, 0.1);
}

TEST(InelasticCells, HaveTheForcesOfTheDeviatoricStiffness)
{
  // no strength
  expectForcesOfStiffness<2>(1, vonMises(1e-200), 0);
  expectForcesOfStiffness<2>(2, vonMises(1e-200), 0);
  expectForcesOfStiffness<3>(3, vonMises(1e-200), 0);
}

TEST(InelasticCells, HaveTheForcesOfTheStiffnessWhereTheyOpen)
{
  // far beyond the apex
  const Law opening{"Drucker-Prager", {0, 90, 0, 0, 1, 1, 90, 0, 0}, 1e4};
  expectForcesOfStiffness<2>(2, opening, material.bulk_modulus);
  expectForcesOfStiffness<3>(3, opening, material.bulk_modulus);
}

// The stress of associated flow is the gradient of a convex potential whose second derivative
// nowhere exceeds that of elastic rock: for two motions with the strains x, the inelastic strains
// e and their differences d,
//   dx : C de >= de : C de
TEST(InelasticCells, HaveAConvexPotentialInAssociatedFlow)
{
  const Sample<3> sample(3, {"Drucker-Prager", {10, 30, 0, 0, 1, 1, 30, 0, 0}, -20});
  auto const before = sample.cells.none(), one = sample.cells.none(), two = sample.cells.none();
  for (int sequence = 0; sequence < 20; ++sequence) {
    auto const u = sample.motion(2 * sequence), v = sample.motion(2 * sequence + 1),
               f = rcp(new Vector(sample.dofs->owned()));
    sample.cells.respond(*u, 1, before, one);
    sample.cells.respond(*v, 1, before, two);
    auto const e = differenceOf(one.strain, two.strain);
    sample.cells.addForces(e, *f);
    u->update(-1, *v, 1);
    const double work = u->dot(*f), twice_energy = 2 * sample.cells.energy(e);
    EXPECT_GE(work, twice_energy);
    EXPECT_GT(twice_energy, 0.01 * work);
  }
}

// A nan in one cell of the rock must not pass for a strain that has converged.
TEST(InelasticCells, HaveNoFiniteDistanceToAStrainThatIsNone)
{
  const Sample<2> sample(2, vonMises(10));
  auto const before = sample.cells.none(), after = sample.cells.none();
  sample.cells.respond(*sample.motion(1), 1, before, after);
  const TensorView broken("broken", after.strain.extent(0), after.strain.extent(1));
  Kokkos::deep_copy(broken, after.strain);
  if (broken.extent(0) > 0) {
    Kokkos::deep_copy(Kokkos::subview(broken, 0, 0), std::numeric_limits<double>::quiet_NaN());
  }
  for (const bool as_maximum : {false, true}) {
    EXPECT_EQ(sample.cells.distance(after.strain, after.strain, as_maximum), 0);
    EXPECT_FALSE(std::isfinite(sample.cells.distance(after.strain, broken, as_maximum)));
    EXPECT_FALSE(std::isfinite(sample.cells.distance(broken, after.strain, as_maximum)));
  }
}
} // namespace asperity::fem
