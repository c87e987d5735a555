#include "MeshSamples.hpp"

#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/parallel/Partition.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <set>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
Teuchos::MpiComm<int> world() { return Teuchos::MpiComm<int>(MPI_COMM_WORLD); }

template <std::size_t N>
std::array<long long, N> globalIds(std::array<int, N> const& simplex,
                                   std::vector<GlobalOrdinal> const& ids)
{
  std::array<long long, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = ids[static_cast<std::size_t>(simplex[i])];
  }
  return result;
}

// All simplices of the whole mesh with an owned vertex, as global numbers.
template <std::size_t N>
std::set<std::array<long long, N>> touching(std::vector<std::array<int, N>> const& simplices,
                                            std::vector<bool> const& is_owned)
{
  std::set<std::array<long long, N>> result;
  for (auto const& simplex : simplices) {
    std::array<long long, N> ids;
    std::copy(simplex.begin(), simplex.end(), ids.begin());
    if (std::any_of(ids.begin(), ids.end(), [&](long long id) { return is_owned[id]; })) {
      result.insert(ids);
    }
  }
  return result;
}

template <std::size_t N>
std::set<std::array<long long, N>> localOnes(std::vector<std::array<int, N>> const& simplices,
                                             std::vector<GlobalOrdinal> const& ids)
{
  std::set<std::array<long long, N>> result;
  for (auto const& simplex : simplices) {
    result.insert(globalIds(simplex, ids));
  }
  return result;
}

template <int Dim>
void expectGoodPart(GlobalMesh<Dim> const& mesh, Mesh<Dim> const& part)
{
  const auto num_local = static_cast<int>(part.vertices.size());
  ASSERT_EQ(part.global_ids.size(), part.vertices.size());
  EXPECT_EQ(part.num_global_vertices, static_cast<long long>(mesh.vertices.size()));
  EXPECT_EQ(part.region_names, mesh.region_names);
  EXPECT_GT(part.num_owned, 0);
  std::vector<bool> is_owned(mesh.vertices.size(), false);
  for (int v = 0; v < num_local; ++v) {
    EXPECT_EQ(part.vertices[v], mesh.vertices[part.global_ids[v]]);
    is_owned[part.global_ids[v]] = v < part.num_owned;
  }
  const auto ids = part.global_ids.begin();
  EXPECT_TRUE(std::is_sorted(ids, ids + part.num_owned));
  EXPECT_TRUE(std::is_sorted(ids + part.num_owned, part.global_ids.end()));

  // Complete rows: exactly the cells and facets with an owned vertex, and no other vertex.
  EXPECT_EQ(localOnes(part.cells, part.global_ids), touching(mesh.cells, is_owned));
  std::set<int> used;
  for (auto const& cell : part.cells) {
    used.insert(cell.begin(), cell.end());
  }
  EXPECT_EQ(static_cast<int>(used.size()), num_local);
  ASSERT_EQ(part.boundaries.size(), mesh.boundaries.size());
  for (auto const& [name, facets] : mesh.boundaries) {
    EXPECT_EQ(localOnes(part.boundaries.at(name), part.global_ids), touching(facets, is_owned));
  }
}

// What ranks count at the first vertex's owner sums to the whole.
template <int Dim>
void expectSums(GlobalMesh<Dim> const& mesh, Mesh<Dim> const& part)
{
  std::vector<double> measures(mesh.region_names.size(), 0.0);
  for (std::size_t c = 0; c < part.cells.size(); ++c) {
    if (part.cells[c][0] < part.num_owned) {
      measures[part.cell_regions[c]] += signedMeasure(corners<Dim>(part.vertices, part.cells[c]));
    }
  }
  for (std::size_t r = 0; r < measures.size(); ++r) {
    EXPECT_NEAR(sumOverRanks(measures[r], world()), measureOf(mesh, static_cast<int>(r)), 1e-13);
  }
  for (auto const& [name, facets] : part.boundaries) {
    Point<Dim> normal{};
    for (auto const& facet : facets) {
      const auto one = areaNormal(corners<Dim>(part.vertices, facet));
      for (int d = 0; d < Dim && facet[0] < part.num_owned; ++d) {
        normal[d] += one[d];
      }
    }
    expectNear(sumOverRanks(normal, world()), integralOfNormal(mesh, name), 1e-13, name);
  }
}

template <int Dim>
void expectGoodDistribution(GlobalMesh<Dim> const& mesh)
{
  const auto part = distribute(mesh, world());
  expectGoodPart(mesh, part);
  EXPECT_EQ(sumOverRanks(part.num_owned, world()), static_cast<int>(mesh.vertices.size()));
  long long sum_of_ids = 0;
  for (int v = 0; v < part.num_owned; ++v) {
    sum_of_ids += part.global_ids[v];
  }
  const auto n = static_cast<long long>(mesh.vertices.size());
  EXPECT_EQ(sumOverRanks(sum_of_ids, world()), n * (n - 1) / 2);
  expectSums(mesh, part);
}
} // namespace

TEST(Partition, DistributesTheWedge) { expectGoodDistribution(coarseWedge(0.01)); }

TEST(Partition, DistributesTheCube)
{
  auto mesh = cube();
  orientFacets(mesh);
  expectGoodDistribution(mesh);
}

// Hardly more vertices than ranks.
TEST(Partition, DistributesTwoTriangles) { expectGoodDistribution(square()); }

TEST(Partition, OnePartIsTheMesh)
{
  const auto mesh = coarseWedge(0.01);
  const auto part = localPart(mesh, std::vector<int>(mesh.vertices.size(), 0), 0);
  EXPECT_EQ(part.vertices, mesh.vertices);
  EXPECT_EQ(part.cells, mesh.cells);
  EXPECT_EQ(part.cell_regions, mesh.cell_regions);
  EXPECT_EQ(part.boundaries, mesh.boundaries);
  EXPECT_EQ(part.num_owned, static_cast<int>(mesh.vertices.size()));
}

TEST(Partition, IsBalancedAndTheSameAgain)
{
  const auto mesh = coarseWedge(0.01);
  for (int num_parts : {1, 2, 3, 7}) {
    const auto owners = partitionVertices(mesh, num_parts);
    EXPECT_EQ(owners, partitionVertices(mesh, num_parts));
    std::vector<double> sizes(num_parts, 0.0);
    for (int owner : owners) {
      ++sizes.at(owner);
    }
    for (double size : sizes) {
      EXPECT_NEAR(size * num_parts / static_cast<double>(owners.size()), 1.0, 0.15)
        << num_parts << " parts";
    }
  }
}

// Few edges of the mesh are cut: a straight cut of this square in two costs 31 vertices' edges.
TEST(Partition, CutsFewCells)
{
  const auto mesh = rectangleMesh({1.0, 1.0, 30, 30, {0.0, 0.0}});
  const auto owners = partitionVertices(mesh, 2);
  int num_cut = 0;
  for (auto const& cell : mesh.cells) {
    num_cut += owners[cell[0]] != owners[cell[1]] || owners[cell[0]] != owners[cell[2]] ? 1 : 0;
  }
  EXPECT_GT(num_cut, 0);
  EXPECT_LT(num_cut, 4 * 30);
}

// A square of 31 x 31 with a bottom of 31, in two parts of which one has most of the bottom.
TEST(Partition, WeighsTheVerticesOfABoundary)
{
  const auto mesh = rectangleMesh({1.0, 1.0, 30, 30, {0.0, 0.0}});
  const int weight = 60;
  const auto owners = partitionVertices(mesh, 2, {"bottom", weight});
  std::vector<double> weights(2, 0.0);
  for (int owner : owners) {
    ++weights[owner];
  }
  for (int vertex : boundaryVertices(mesh, "bottom")) {
    weights[owners[vertex]] += weight - 1;
  }
  EXPECT_NEAR(weights[0] / weights[1], 1.0, 0.15);
  test::expectRefusal(
    [&] {
      partitionVertices(mesh, 2, {"botom", 4});
    },
    {"Did you mean 'bottom'?"});
}

TEST(Partition, MeasuresTheImbalance)
{
  const std::vector<int> owners = {0, 2, 2, 1, 2, 2};
  EXPECT_DOUBLE_EQ(imbalance(owners, 3), 4.0 / 2.0);
  EXPECT_DOUBLE_EQ(imbalance(owners, 3, {0, 1, 3}), 1.0);
  EXPECT_DOUBLE_EQ(imbalance(owners, 3, {1, 2}), 3.0);
}

// Weights alone leave some parts with several times the mean of the fault: see the end of the test.
TEST(Partition, BalancesTheFaultToo)
{
  const auto mesh = boxMesh({{1.0, 1.0, 1.0}, {16, 16, 16}, {0.0, 0.0, 0.0}});
  const auto fault = boundaryVertices(mesh, "bottom");
  double largest_without = 0.0;
  for (int num_parts : {2, 3, 4, 8, 16}) {
    // METIS is a few vertices off its tolerances, which matters for 18 on the fault of a part.
    const auto owners = partitionVertices(mesh, num_parts, {"bottom", 1});
    EXPECT_LT(imbalance(owners, num_parts), 1.06) << num_parts << " parts";
    EXPECT_LT(imbalance(owners, num_parts, fault), 1.12) << num_parts << " parts";
    largest_without =
      std::max(largest_without, imbalance(partitionVertices(mesh, num_parts), num_parts, fault));
  }
  EXPECT_GT(largest_without, 2.0);
}

// Every part gets a vertex of the boundary only if there are so many.
TEST(Partition, TakesMorePartsThanTheBoundaryHasVertices)
{
  const auto mesh = rectangleMesh({1.0, 1.0, 2, 30, {0.0, 0.0}});
  const auto owners = partitionVertices(mesh, 8, {"bottom", 4});
  EXPECT_EQ(std::set<int>(owners.begin(), owners.end()).size(), 8u);
  // METIS aims at 13 vertices of 93 / 8, 1.12. How far it misses that in such small parts has no
  // bound; 1.5, or 17 vertices, was chosen after the result.
  EXPECT_LT(imbalance(owners, 8), 1.5);
}

TEST(Partition, MakesAllPartsAtOnce)
{
  const auto mesh = coarseWedge(0.01);
  const auto owners = partitionVertices(mesh, 5);
  const auto parts = localParts(mesh, owners, 5);
  ASSERT_EQ(parts.size(), 5u);
  for (int p = 0; p < 5; ++p) {
    const auto alone = localPart(mesh, owners, p);
    EXPECT_EQ(parts[p].mesh.global_ids, alone.global_ids);
    EXPECT_EQ(parts[p].mesh.cells, alone.cells);
    EXPECT_EQ(parts[p].mesh.boundaries, alone.boundaries);
    for (std::size_t c = 0; c < parts[p].cells.size(); ++c) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(alone.global_ids[alone.cells[c][i]], mesh.cells[parts[p].cells[c]][i]);
      }
    }
  }
}

TEST(Partition, EveryPartHasAVertex)
{
  const auto mesh = cube();
  const auto owners = partitionVertices(mesh, 8);
  EXPECT_EQ(std::set<int>(owners.begin(), owners.end()).size(), 8u);
  test::expectRefusal([&] { partitionVertices(mesh, 9); }, {"8 vertices", "9 ranks"});
}

TEST(Partition, BroadcastGivesEveryRankTheMesh)
{
  auto mesh = square();
  mesh.boundaries["empty"] = {};
  const auto original = mesh;
  if (world().getRank() != 0) {
    mesh = GlobalMesh<2>();
    mesh.boundaries["other"] = {{0, 1}};
  }
  broadcast(mesh, world());
  expectEqual(mesh, original);
}
