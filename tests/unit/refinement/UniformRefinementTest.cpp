#include "RefinementSamples.hpp"

#include "mesh/MeshQuality.hpp"

using namespace asperity;
using namespace asperity::refinement;
using namespace asperity::refinement::test;

namespace
{
// Cells as the coordinates of their corners, sorted: how they are numbered does not matter.
template <int Dim>
std::vector<std::array<Point<Dim>, Dim + 1>> places(GlobalMesh<Dim> const& mesh)
{
  std::vector<std::array<Point<Dim>, Dim + 1>> cells;
  for (auto const& cell : mesh.cells) {
    auto points = corners(mesh, cell);
    std::sort(points.begin(), points.end());
    cells.push_back(points);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

template <int Dim>
void expectSameMeasures(GlobalMesh<Dim> const& coarse, GlobalMesh<Dim> const& fine)
{
  for (std::size_t r = 0; r < coarse.region_names.size(); ++r) {
    const auto region = static_cast<int>(r);
    EXPECT_NEAR(measureOf(fine, region), measureOf(coarse, region), 1e-13);
  }
  for (auto const& [name, facets] : coarse.boundaries) {
    expectNear(integralOfNormal(fine, name), integralOfNormal(coarse, name), 1e-13, name);
    EXPECT_EQ(fine.boundaries.at(name).size(), facets.size() << (Dim - 1)) << name;
  }
}

// What must hold of every mesh: what all ranks refine together is what one refines alone, which is
// conforming, has the same regions and boundaries, and 2^Dim times as many cells.
template <int Dim>
void expectGoodRefinement(GlobalMesh<Dim> const& coarse, int refinements)
{
  SCOPED_TRACE(refinements);
  const auto fine = wholeRefined(coarse, refinements);
  expectConforming(fine);
  EXPECT_EQ(fine.cells.size(), coarse.cells.size() << (Dim * refinements));
  if (refinements == 1) {
    expectSameMeasures(coarse, fine);
  }
  expectPartOf(fine, refined(coarse, refinements));
}
} // namespace

TEST(UniformRefinement, ZeroLeavesTheMeshAsItIs)
{
  const auto part = distribute(unitBox(2), world());
  const auto same = refineUniformly(part, 0, world());
  EXPECT_EQ(same.cells, part.cells);
  EXPECT_EQ(same.global_ids, part.global_ids);
}

TEST(UniformRefinement, OfTheWedge)
{
  expectGoodRefinement(coarseWedge(0.01), 1);
  expectGoodRefinement(coarseWedge(0.01), 3);
}

TEST(UniformRefinement, OfTwoTriangles)
{
  auto mesh = square();
  mesh.boundaries["rest"] = {{1, 2}, {3, 0}};
  for (int refinements : {1, 2, 5}) {
    if (world().getSize() <= 4) {
      expectGoodRefinement(mesh, refinements);
    }
  }
}

TEST(UniformRefinement, OfABox)
{
  expectGoodRefinement(unitBox(3), 1);
  expectGoodRefinement(unitBox(2), 2);
}

TEST(UniformRefinement, OfCrookedCells)
{
  expectGoodRefinement(crookedBox(3, 0.3), 1);
  expectGoodRefinement(crookedBox(2, 0.3), 3);
}

TEST(UniformRefinement, OfAPeriodicBox)
{
  expectGoodRefinement(periodicBox(3), 1);
  expectGoodRefinement(periodicBox(4), 2);
}

TEST(UniformRefinement, CountsTheVerticesOfABox)
{
  for (int n = 1; n <= 3; ++n) {
    const int side = (2 << n) + 1;
    EXPECT_EQ(refined(unitBox(2), n).num_global_vertices, side * side * side);
    EXPECT_EQ(refined(rectangleMesh({2, 1, 2, 2, {}}), n).num_global_vertices, side * side);
  }
}

// A generator that makes cubes of six tetrahedra around one diagonal gives the same mesh at once.
TEST(UniformRefinement, OfABoxIsAFinerBox)
{
  EXPECT_TRUE(places(wholeRefined(unitBox(2), 1)) == places(unitBox(4)));
  EXPECT_TRUE(places(wholeRefined(unitBox(2), 2)) == places(unitBox(8)));
}

// Bey's rule: three shapes for each first cell, all of which are there after two refinements.
TEST(UniformRefinement, KeepsAnglesHoweverOften)
{
  for (double amplitude : {0.0, 0.3}) {
    const auto box = crookedBox(2, amplitude);
    std::vector<double> angles;
    for (int n = 0; n <= 4; ++n) {
      angles.push_back(cellSizes(wholeRefined(box, n)).smallest_angle);
    }
    EXPECT_GT(angles[2], 0.5 * angles[0]);
    EXPECT_NEAR(angles[3], angles[2], 1e-9);
    EXPECT_NEAR(angles[4], angles[2], 1e-9);
  }
  const auto wedge = coarseWedge(0.01);
  EXPECT_NEAR(cellSizes(wholeRefined(wedge, 3)).smallest_angle, cellSizes(wedge).smallest_angle,
              1e-9);
}

// No rank gets more than its share: what is at the border of parts is divided between them, and
// the partition of the coarse mesh counts cells instead of vertices.
TEST(UniformRefinement, KeepsTheBalance)
{
  const auto coarse = unitBox(6);
  PartitionOptions options;
  options.boundary = "bottom";
  options.by_cells = true;
  const auto fine = refineUniformly(distribute(coarse, world(), options), 3, world());
  const auto largest_over_mean = [](auto mine) {
    return maxOverRanks(double(mine), world()) * world().getSize() /
           sumOverRanks(double(mine), world());
  };
  EXPECT_LT(largest_over_mean(fine.num_owned), 1.08);
  EXPECT_LT(largest_over_mean(fine.cells.size()), 1.08);
  const auto bottom = boundaryVertices(fine, "bottom");
  EXPECT_LT(largest_over_mean(std::count_if(bottom.begin(), bottom.end(),
                                            [&](int v) { return v < fine.num_owned; })),
            1.12);
}

TEST(UniformRefinement, RefusesWhatDoesNotFit)
{
  const auto part = distribute(unitBox(2), world());
  const auto refuse = [&](int refinements, std::vector<std::string> const& pieces) {
    asperity::test::expectRefusal([&] { refineUniformly(part, refinements, world()); }, pieces);
  };
  refuse(-1, {"Mesh / Refinements = -1 is outside [0, inf)"});
  refuse(9, {"Mesh / Refinements = 9 makes some", "6.44245e+09 cells"});
  refuse(30, {"Mesh / Refinements = 30 makes some", " bits can number"});
  refuse(2000, {"Mesh / Refinements = 2000 makes some", " bits can number"});
}
