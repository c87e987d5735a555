#include "MeshSamples.hpp"

#include "mesh/Boundaries.hpp"
#include "mesh/Regions.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"
#include "mesh/parallel/Partition.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
RCP<const Communicator> world() { return rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)); }

template <int Dim>
using Conditions = std::vector<NamedCondition<Dim>>;

// Naming and then dividing is the same as dividing and then naming.
template <int Dim>
void expectTheSame(GlobalMesh<Dim> whole, Conditions<Dim> const& regions,
                   Conditions<Dim> const& boundaries)
{
  const auto communicator = world();
  const auto owners = partitionVertices(whole, communicator->getSize());
  const int rank = communicator->getRank();
  auto part = localPart(whole, owners, rank);
  overrideRegions(part, regions, *communicator);
  overrideBoundaries(part, boundaries, *communicator);
  overrideRegions(whole, regions);
  overrideBoundaries(whole, boundaries);
  const auto expected = localPart(whole, owners, rank);
  EXPECT_EQ(part.region_names, expected.region_names);
  EXPECT_EQ(part.cell_regions, expected.cell_regions);
  EXPECT_EQ(part.boundaries, expected.boundaries);
}
} // namespace

// `right` loses all its facets, and so does the region `upper`.
TEST(OverridePart, IsThePartOfTheWholeWedge)
{
  const auto anywhere = [](Point<2> const&) { return true; };
  const auto deep = [](Point<2> const& x) { return x[0] > 0.5; };
  WedgeShape shape;
  shape.cell_size = 0.01;
  shape.viscous_thickness = 0.0;
  expectTheSame<2>(wedgeMesh(shape), {{"all", anywhere}, {"deep", deep}},
                   {{"surface", deep}, {"tip", [](auto const& x) { return x[0] < 0.1; }}});
}

// Periodic along z: the facets of cells across the period are where they were.
TEST(OverridePart, IsThePartOfTheWholeBox)
{
  auto mesh = boxMesh({{1.0, 2.0, 3.0}, {4, 5, 6}, {0.0, 0.0, 0.0}});
  makePeriodic<3>(mesh, 2, "front", "back");
  expectTheSame<3>(mesh, {{"far", [](auto const& x) { return x[2] > 2.5; }}},
                   {{"left", [](auto const& x) { return x[2] > 2.5; }},
                    {"patch", [](auto const& x) { return x[1] == 0.0 && x[0] + x[2] < 1.0; }},
                    {"top", [](auto const& x) { return x[1] == 2.0; }}});
}

// One cell and one facet far away from most ranks: all throw or none does.
TEST(OverridePart, AgreesOnWhatIsMissing)
{
  const auto communicator = world();
  const auto whole = boxMesh({{1.0, 1.0, 1.0}, {4, 4, 4}, {0.0, 0.0, 0.0}});
  auto part = distribute(whole, *communicator);
  const auto corner = [](Point<3> const& x) { return x[0] + x[1] + x[2] < 0.3; };
  const auto nowhere = [](Point<3> const& x) { return x[0] > 2.0; };
  overrideBoundaries<3>(part, {{"corner", corner}}, *communicator);
  EXPECT_EQ(part.boundaries.count("corner"), 1u);
  EXPECT_EQ(part.boundaries.size(), whole.boundaries.size() + 1);
  test::expectRefusal(
    [&] {
      overrideBoundaries<3>(part, {{"none", nowhere}}, *communicator);
    },
    {"Mesh / Boundaries / none: the boundary has no facet"});
  test::expectRefusal(
    [&] {
      overrideRegions<3>(part, {{"none", nowhere}}, *communicator, "Here");
    },
    {"Here / none: the region has no cell"});
}
