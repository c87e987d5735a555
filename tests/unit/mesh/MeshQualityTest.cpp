#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"

using namespace asperity;
using namespace asperity::mesh;

TEST(MeshQuality, SizesOfSquareAndCube)
{
  const auto flat = cellSizes(square());
  EXPECT_DOUBLE_EQ(flat.largest_diameter, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(flat.smallest_diameter, std::sqrt(2.0));
  EXPECT_NEAR(flat.smallest_angle, std::atan(1.0), 1e-14);
  EXPECT_DOUBLE_EQ(flat.measure, 1.0);
  const auto solid = cellSizes(cube());
  EXPECT_DOUBLE_EQ(solid.largest_diameter, std::sqrt(3.0));
  EXPECT_NEAR(solid.smallest_angle, std::atan(1.0), 1e-14);
  EXPECT_NEAR(solid.measure, 1.0, 1e-15);
}

TEST(MeshQuality, NamesThePlacesOfTheSmallestAngleAndTheShortestEdge)
{
  auto mesh = square(); // cells of the corners 0, 1, 2 and 0, 2, 3
  mesh.vertices[3] = {0.0, 0.5};
  const auto sizes = cellSizes(mesh);
  EXPECT_DOUBLE_EQ(sizes.shortest_edge, 0.5);
  EXPECT_DOUBLE_EQ(sizes.place_of_shortest_edge[0], 0);
  EXPECT_DOUBLE_EQ(sizes.place_of_shortest_edge[1], 0.25);
  // At (1, 1) between the edges to (0, 0.5) and (0, 0).
  EXPECT_NEAR(sizes.smallest_angle, std::atan(1.0) - std::atan(0.5), 1e-14);
  EXPECT_NEAR(sizes.place_of_smallest_angle[0], 1.0 / 3, 1e-15);
  EXPECT_NEAR(sizes.place_of_smallest_angle[1], 0.5, 1e-15);
}

TEST(MeshQuality, DiametersAreLongestEdges)
{
  auto mesh = square();
  mesh.vertices[3] = {0.0, 2.0};
  const auto diameters = cellDiameters(mesh);
  ASSERT_EQ(diameters.size(), 2u);
  EXPECT_DOUBLE_EQ(diameters[0], std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(diameters[1], 2.0);
  Mesh<2> local;
  local.vertices = mesh.vertices;
  local.cells = {mesh.cells[1]};
  EXPECT_EQ(cellDiameters(local), std::vector<double>{2.0});
}

TEST(MeshQuality, BoundaryVerticesAreSortedAndUnique)
{
  auto mesh = square();
  mesh.boundaries["bent"] = {{2, 3}, {3, 0}};
  EXPECT_EQ(boundaryVertices(mesh, "bent"), (std::vector<int>{0, 2, 3}));
  EXPECT_DOUBLE_EQ(shortestEdge(mesh, "bent"), 1.0);
  mesh.vertices[3] = {0.0, 0.75};
  EXPECT_DOUBLE_EQ(shortestEdge(mesh, "bent"), 0.75);
  EXPECT_EQ(boundaryVertices(cube(), "side"), (std::vector<int>{0, 2, 4, 6}));
}

TEST(MeshQuality, NamesTheBoundaryThatIsMissing)
{
  test::expectRefusal([] { boundaryVertices(square(), "botom"); },
                      {"no boundary 'botom'", "Did you mean 'bottom'?"});
  test::expectRefusal([] { boundaryFacets(square(), "fault"); }, {"'bottom', 'top'"});
}

TEST(MeshQuality, NormalsPointOutwardWithTheMeasureOfTheFacet)
{
  auto mesh = square();
  const auto facet = corners(mesh, mesh.boundaries["top"][0]);
  EXPECT_EQ(facetNormal(facet), (Point<2>{0.0, 1.0}));
  EXPECT_DOUBLE_EQ(facetMeasure(facet), 1.0);
  auto solid = cube();
  solid.vertices[6] = {0.0, 2.0, 2.0};
  orientFacets(solid);
  const auto triangle = corners(solid, solid.boundaries["side"][0]);
  EXPECT_EQ(facetNormal(triangle), (Point<3>{-1.0, 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(facetMeasure(triangle), 1.0);
}
