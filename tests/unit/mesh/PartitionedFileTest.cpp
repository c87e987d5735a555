#include "FaultSamples.hpp"
#include "SharedFolder.hpp"

#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
using mesh::expectEqual;

RCP<const Communicator> world() { return rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)); }

// Periodic along z, in two regions, with a boundary that has no facet.
GlobalMesh<3> periodicBox()
{
  auto mesh = boxMesh({{1.0, 2.0, 3.0}, {4, 5, 6}, {0.5, 0.0, -1.0}});
  makePeriodic<3>(mesh, 2, "front", "back");
  mesh.region_names = {"first", "second"};
  for (std::size_t c = 0; c < mesh.cells.size(); c += 3) {
    mesh.cell_regions[c] = 1;
  }
  mesh.boundaries["nothing"] = {};
  return mesh;
}

template <int Dim>
void expectEqual(Mesh<Dim> const& part, Mesh<Dim> const& other)
{
  EXPECT_EQ(part.vertices, other.vertices);
  EXPECT_EQ(part.global_ids, other.global_ids);
  EXPECT_EQ(part.num_owned, other.num_owned);
  EXPECT_EQ(part.num_global_vertices, other.num_global_vertices);
  EXPECT_EQ(part.period, other.period);
  EXPECT_EQ(part.cells, other.cells);
  EXPECT_EQ(part.cell_regions, other.cell_regions);
  EXPECT_EQ(part.region_names, other.region_names);
  EXPECT_EQ(part.boundaries, other.boundaries);
  EXPECT_EQ(part.splits, other.splits);
  EXPECT_EQ(part.faults, other.faults);
}

class PartitionedFile : public SharedFolder
{
protected:
  template <int Dim>
  void write(GlobalMesh<Dim> const& mesh, int num_parts, std::string const& name,
             PartitionOptions const& options = {}) const
  {
    onFirstRank([&] {
      writeParts(mesh, partitionVertices(mesh, num_parts, options), num_parts, options, file(name));
    });
  }

  // Every rank gets its part of the whole mesh; at last from 8 parts by way of the whole mesh.
  template <int Dim>
  void expectParts(GlobalMesh<Dim> const& mesh, PartitionOptions const& options) const
  {
    const int num_ranks = world()->getSize();
    const auto owners = partitionVertices(mesh, num_ranks, options);
    const auto expected = localPart(mesh, owners, world()->getRank());
    write(mesh, num_ranks, "ranks.h5", options);
    expectEqual(readPart<Dim>(file("ranks.h5"), world()), expected);

    write(mesh, 8, "eight.h5", options);
    const auto again = readParts<Dim>(file("eight.h5"));
    expectEqual(again, mesh);
    const auto summary = partitionSummary(file("eight.h5"));
    EXPECT_EQ(summary.num_parts, 8);
    EXPECT_EQ(summary.fingerprint, partitionSummary(file("ranks.h5")).fingerprint);
    EXPECT_EQ(summary.options.boundary, options.boundary);
    write(again, num_ranks, "again.h5", summary.options);
    expectEqual(readPart<Dim>(file("again.h5"), world()), expected);
  }
};
} // namespace

TEST_F(PartitionedFile, GivesEveryRankItsPartOfTheWedge)
{
  expectParts<2>(coarseWedge(0.02), {"base", 4});
}

TEST_F(PartitionedFile, GivesEveryRankItsPartOfTheBox)
{
  const auto mesh = periodicBox();
  ASSERT_EQ(mesh.period, (Point<3>{0.0, 0.0, 3.0}));
  expectParts<3>(mesh, {"bottom", 4});
}

TEST_F(PartitionedFile, GivesEveryRankItsPartOfAFaultedBox)
{
  auto mesh = faultedBox({{"main", [](auto& p) { return p[1] == 0.0; }},
                          {"splay", [](auto& p) { return p[0] == 2.0 && p[1] >= 0.0; }}});
  splitFaults(mesh, "test");
  ASSERT_EQ(mesh.splits.size(), 40u);
  expectParts<3>(mesh, {"main", 4});
}

TEST_F(PartitionedFile, GivesEveryRankItsPartOfFaultsThatCross)
{
  const auto mesh = split(faultedRectangle(
    {{"dyke", [](auto& p) { return p[0] == 2.0; }}, {"main", [](auto& p) { return p[1] == 0.0; }}},
    2));
  ASSERT_EQ(crossingsOf(mesh.splits).size(), 1u);
  expectParts<2>(mesh, {"main", 4});
  const auto in_space = split(faultedBox({{"dyke", [](auto& p) { return p[0] == 2.0; }},
                                          {"main", [](auto& p) { return p[1] == 0.0; }}}));
  ASSERT_EQ(crossingsOf(in_space.splits).size(), 5u);
  expectParts<3>(in_space, {"main", 4});
}

// A mesh that is not partitioned is not split in its file either.
TEST_F(PartitionedFile, SplitsWhatWasWritten)
{
  const auto mesh = faultedRectangle({{"fault", [](auto& p) { return p[0] == 2.0; }}});
  onFirstRank([&] { writeMesh(mesh, file("mesh.h5")); });
  auto read = readMesh<2>(file("mesh.h5"), *world());
  EXPECT_EQ(read.boundaries.at("fault").size(), 4u);
  splitFaults(read, "test");
  expectEqual(read, split(mesh));
}

TEST_F(PartitionedFile, KnowsItsKind)
{
  write(cube(), 2, "parts.h5");
  onFirstRank([&] { writeMesh(square(), file("mesh.h5")); });
  EXPECT_TRUE(isPartitioned(file("parts.h5"), *world()));
  EXPECT_FALSE(isPartitioned(file("mesh.h5"), *world()));
  EXPECT_EQ(fileDimension(file("parts.h5"), *world()), 3);
  EXPECT_EQ(fileDimension(file("mesh.h5"), *world()), 2);
  test::expectRefusal([&] { isPartitioned(file("none.h5"), *world()); },
                      {"none.h5' does not exist"});
  test::expectRefusal([&] { fileDimension(file("none.h5"), *world()); },
                      {"none.h5' does not exist"});
  test::expectRefusal([&] { readMesh<3>(file("parts.h5")); }, {"asperity-partition"});
}

// Two meshes with different fingerprints differ in one coordinate.
TEST_F(PartitionedFile, HasTheFingerprintOfItsMesh)
{
  auto mesh = cube();
  write(mesh, 2, "one.h5");
  mesh.vertices[7][0] = 1.0 + 1e-15;
  write(mesh, 2, "other.h5");
  EXPECT_NE(partitionSummary(file("one.h5")).fingerprint,
            partitionSummary(file("other.h5")).fingerprint);
}

TEST_F(PartitionedFile, SaysThatItCannotBeWritten)
{
  const auto mesh = square();
  const std::vector<int> owners(4, 0);
  test::expectRefusal([&] { writeParts(mesh, owners, 1, {}, file("no folder/a.h5")); },
                      {"no folder/a.h5", "cannot be written"});
  EXPECT_FALSE(std::filesystem::exists(file("no folder")));
}
