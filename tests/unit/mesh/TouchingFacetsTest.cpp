// Bodies that touch without common vertices, whole and in parts.
#include "mesh/TouchingFacets.hpp"

#include "FaultSamples.hpp"

#include "mesh/parallel/Partition.hpp"

#include <Teuchos_DefaultComm.hpp>

namespace asperity::mesh
{
namespace
{
// [0, 4] x [-2, 2] in `rows` rows, and beside it [4, 8] x [-2, 2] in `other_rows` rows, which share
// no vertices.
GlobalMesh<2> twoBodies(int rows, int other_rows, double gap = 0)
{
  auto mesh = rectangleMesh({4.0, 4.0, 4, rows, {0.0, -2.0}});
  const auto other = rectangleMesh({4.0, 4.0, 4, other_rows, {4.0 + gap, -2.0}});
  const auto first = static_cast<int>(mesh.vertices.size());
  mesh.region_names = {"west", "east"};
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (auto cell : other.cells) {
    for (int& vertex : cell) {
      vertex += first;
    }
    mesh.cells.push_back(cell);
    mesh.cell_regions.push_back(1);
  }
  mesh.boundaries = {{"fault", mesh.boundaries.at("right")},
                     {"base", mesh.boundaries.at("bottom")}};
  return mesh;
}

GlobalMesh<3> twoCubes()
{
  auto mesh = cube();
  const auto first = static_cast<int>(mesh.vertices.size());
  const auto other = cube();
  for (auto x : other.vertices) {
    x[0] += 1;
    mesh.vertices.push_back(x);
  }
  for (auto cell : other.cells) {
    for (int& vertex : cell) {
      vertex += first;
    }
    mesh.cells.push_back(cell);
    mesh.cell_regions.push_back(0);
  }
  return mesh;
}
} // namespace

TEST(TouchingFacets, EqualDivisions)
{
  const auto found = touchingFacets(twoBodies(8, 8));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->number, 8);
  EXPECT_EQ(found->first, "west");
  EXPECT_EQ(found->second, "east");
  EXPECT_EQ(found->boundary, "fault");
  EXPECT_EQ(found->place[0], 4);
  const auto text = sentence(*found);
  EXPECT_NE(text.find("8 facets of region 'west' lie on facets of region 'east' without sharing "
                      "vertices, the first at (4, "),
            std::string::npos)
    << text;
}

TEST(TouchingFacets, OtherDivisions)
{
  const auto found = touchingFacets(twoBodies(3, 8));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->number, 8); // the small facets on the large ones
  EXPECT_EQ(found->first, "east");
}

TEST(TouchingFacets, InSpace)
{
  const auto found = touchingFacets(twoCubes());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->number, 4); // two of each cube, which are one region
  EXPECT_EQ(found->place[0], 1);
  EXPECT_NE(sentence(*found).find("'rock' lie on facets of the same region"), std::string::npos);
}

TEST(TouchingFacets, NoneWhereBodiesAreApartOrOne)
{
  EXPECT_TRUE(touchingFacets(twoBodies(8, 8, 0.004))); // under a hundredth of 0.5
  EXPECT_FALSE(touchingFacets(twoBodies(8, 8, 0.01)));
  EXPECT_FALSE(touchingFacets(rectangleMesh({4.0, 4.0, 4, 4, {0.0, -2.0}})));
  EXPECT_FALSE(touchingFacets(coarseWedge(0.02)));
  const auto fault = faultedRectangle(
    {{"fault", [](Point<2> const& x) { return std::abs(x[1]) < 1e-9 && x[0] < 2 + 1e-9; }}});
  EXPECT_FALSE(touchingFacets(fault));
  EXPECT_FALSE(touchingFacets(split(fault))) << "the two sides of a fault";
}

TEST(TouchingFacets, OfParts)
{
  const auto communicator = Teuchos::DefaultComm<int>::getComm();
  const auto whole = twoBodies(8, 8);
  const auto found = touchingFacets(distribute(whole, *communicator), *communicator);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->number, 8);
  EXPECT_EQ(found->boundary, "fault");
  const auto fault = split(faultedRectangle(
    {{"fault", [](Point<2> const& x) { return std::abs(x[1]) < 1e-9 && x[0] < 2 + 1e-9; }}}, 4));
  EXPECT_FALSE(touchingFacets(distribute(fault, *communicator), *communicator));
}
} // namespace asperity::mesh
