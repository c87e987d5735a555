#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/FlatLayers.hpp"

#include <set>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
constexpr double rounding = 1e-12;

// The heights at which vertices lie, rounded to 1e-9 m.
std::vector<double> heights(GlobalMesh<3> const& mesh)
{
  std::set<double> found;
  for (auto const& x : mesh.vertices) {
    found.insert(std::round(x[2] * 1e9) / 1e9);
  }
  return {found.begin(), found.end()};
}
} // namespace

// 0.3 times a layer of 1 m, 0.45, 0.675; then 1 m and a little more, up to the end.
TEST(FlatLayers, GrowFromAPlaneByHalf)
{
  auto mesh = boxMesh({{2, 2, 16}, {2, 2, 16}, {}});
  flattenLayers(mesh, {2, {0}, 0.3}, "Box");
  expectConforming(mesh);
  const auto z = heights(mesh);
  ASSERT_EQ(z.size(), 17u);
  for (std::size_t layer = 0; layer < 3; ++layer) {
    EXPECT_NEAR(z[layer], 0.6 * (std::pow(1.5, layer) - 1), rounding + 1e-9) << layer;
  }
  for (std::size_t layer = 4; layer < 15; ++layer) {
    EXPECT_NEAR(z[layer + 1] - z[layer], z[16] - z[15], rounding + 2e-9) << layer;
    EXPECT_GT(z[layer + 1] - z[layer], 1);
  }
  EXPECT_DOUBLE_EQ(z.back(), 16);
  EXPECT_NEAR(cellSizes(mesh).measure, 64, 64 * rounding);
}

TEST(FlatLayers, LieOnBothSidesOfInnerPlanes)
{
  auto mesh = boxMesh({{2, 2, 24}, {2, 2, 24}, {0, 0, -12}});
  flattenLayers(mesh, {2, {6, -6}, 0.4}, "Box");
  const auto z = heights(mesh);
  ASSERT_EQ(z.size(), 25u);
  for (std::size_t i = 0; i < z.size(); ++i) {
    EXPECT_NEAR(z[i], -z[24 - i], 2e-9);
  }
  EXPECT_NEAR(z[18], 6, 1e-9);
  EXPECT_NEAR(z[19], 6.4, 1e-9);
  EXPECT_NEAR(z[17], 5.6, 1e-9);
  EXPECT_NEAR(z[12], 0, 1e-9); // halfway, where nothing moves
}

// Sizes that differ along the plane: the smallest cell beside it sets the height.
TEST(FlatLayers, TakeTheSmallestCellBesideThePlane)
{
  auto mesh = bisectBricks<3>(boxMesh({{16, 8, 8}, {2, 1, 1}, {}}), {8, 8, 8},
                              [](Point<3> const& x) { return 1 + 0.3 * (x[0] + x[2]); });
  flattenLayers(mesh, {2, {0}, 0.5}, "Box");
  expectConforming(mesh);
  EXPECT_NEAR(heights(mesh)[1], 0.5, 1e-9);
  EXPECT_NEAR(cellSizes(mesh).measure, 1024, 1e-9);
}

TEST(FlatLayers, NameThePlaneThatDoesNotFit)
{
  const auto flatten = [](double position) {
    auto box = boxMesh({{2, 2, 4}, {2, 2, 4}, {}});
    flattenLayers(box, {2, {position}, 0.3}, "Box");
  };
  test::expectRefusal([&] { flatten(0.5); }, {"Box", "0.5 m"});
  test::expectRefusal([&] { flatten(1); }, {"Box", "more layers", "beside 1 m"});
}
