#include "SurfaceSamples.hpp"

#include "surfaces/grids/GridFile.hpp"

#include <algorithm>
#include <random>

using namespace asperity;
using namespace asperity::geometry;

namespace
{
using GridFiles = FileTest;

// Bilinear, so that grids have it exactly.
double f(double x, double y) { return 1 + 2 * x - 3 * y + 0.5 * x * y; }

Grid gridOf(std::vector<double> const& x, std::vector<double> const& y, bool is_periodic = false)
{
  std::vector<double> z;
  for (const double b : y) {
    for (const double a : x) {
      z.push_back(f(a, b));
    }
  }
  return {x, y, z, is_periodic, "It"};
}

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
} // namespace

TEST(Grid, IsBilinearInEveryDirectionOfItsAxes)
{
  for (auto const& x : {std::vector<double>{0, 1, 3, 4}, {4, 3, 1, 0}}) {
    for (auto const& y : {std::vector<double>{-2, 0, 5}, {5, 0, -2}}) {
      const auto grid = gridOf(x, y);
      for (auto const& [a, b] : {std::pair(0.25, 4.), {3., -2.}, {4., 5.}, {2.5, 0.}, {0., -2.}}) {
        EXPECT_NEAR(grid(a, b), f(a, b), 1e-12) << a << ' ' << b;
      }
    }
  }
}

TEST(Grid, EndsAtItsEdges)
{
  const auto grid = gridOf({0, 1, 3}, {-2, 0, 5});
  test::expectRefusal([&] { grid(3.1, 0); }, {"It", "x = 3.1", "from 0 to 3", "Clamp"});
  test::expectRefusal([&] { grid(1, -2.5); }, {"y = -2.5", "from -2 to 5"});
  EXPECT_NEAR(grid(3.1, -9, Outside::clamp), f(3, -2), 1e-12);
  EXPECT_NEAR(grid(1, 5 + 1e-12), f(1, 5), 1e-9); // rounding of a projection
}

TEST(Grid, HasLongitudesOfBothKinds)
{
  const auto east = gridOf({230, 235, 240}, {40, 50}, true);
  EXPECT_NEAR(east(-126, 45), f(234, 45), 1e-9);
  EXPECT_NEAR(east(-130, 45), f(230, 45), 1e-9);
  EXPECT_NEAR(east(240, 45), f(240, 45), 1e-9);
  const auto west = gridOf({-130, -120}, {40, 50}, true);
  EXPECT_NEAR(west(234, 45), f(-126, 45), 1e-9);
  test::expectRefusal([&] { west(20, 45); }, {"x = 20"});
  EXPECT_NEAR(west(-131, 45, Outside::clamp), f(-130, 45), 1e-9);
  EXPECT_NEAR(west(241, 45, Outside::clamp), f(-120, 45), 1e-9);
  test::expectRefusal([&] { gridOf({-130, -120}, {40, 50})(234, 45); }, {"x = 234"});
}

TEST(Grid, MayHaveGaps)
{
  const Grid grid({0, 1, 2}, {0, 1}, {0, 1, 2, undefined, 1, 2}, false, "It");
  EXPECT_EQ(grid(1.5, 0.5), 1.5);
  EXPECT_EQ(grid(1, 0.5), 1); // the gap has no weight
  test::expectRefusal([&] { grid(0.5, 0.5); }, {"It is not defined at (0.5, 0.5)"});
  const auto surface = grid.surface();
  EXPECT_EQ(surface.points.size(), 5u);
  EXPECT_EQ(surface.triangles.size(), 3u);
}

TEST(Grid, IsASurfaceThroughSomeOfItsLines)
{
  const auto surface = gridOf({0, 1, 2, 3, 4, 5}, {0, 1, 2, 3}).surface(2);
  EXPECT_EQ(surface.points.size(), 4u * 3u); // lines 0 2 4 5 and 0 2 3
  EXPECT_EQ(extentOf(surface, 0), (std::array<double, 2>{0, 5}));
}

TEST(Grid, IsRefused)
{
  test::expectRefusal([] { gridOf({0, 2, 1}, {0, 1}); }, {"It: ", "axis x", "one direction"});
  test::expectRefusal([] { gridOf({0, 1}, {0, undefined}); }, {"axis y"});
  test::expectRefusal([] { gridOf({0}, {0, 1}); }, {"axis x has 1"});
}

TEST_F(GridFiles, Esri)
{
  const std::string values = "NODATA_value -9999\n11 12 13\n21 -9999 23\n";
  const auto corner = readGrid(
    write("a.asc", "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\n" + values));
  EXPECT_EQ(corner.grid.x(), (std::vector<double>{105, 115, 125}));
  EXPECT_EQ(corner.grid.y(), (std::vector<double>{205, 215}));
  EXPECT_EQ(corner.grid(105, 215), 11); // the first row is the northern one
  EXPECT_EQ(corner.grid(125, 205), 23);
  EXPECT_TRUE(std::isnan(corner.grid.z(1, 0)));
  EXPECT_EQ(corner.horizontal_unit, "");
  const auto gap =
    readGrid(write("c.asc", "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n"
                            "NODATA_value nan\nnan 1\n2 3\n"));
  EXPECT_TRUE(std::isnan(gap.grid.z(0, 1)));
  EXPECT_EQ(gap.grid(1, 0.5), 2);
  const auto centre = readGrid(
    write("b.asc", "NCOLS 3\nNROWS 2\nXLLCENTER 100\nYLLCENTER 200\nDX 10\nDY 5\n" + values));
  EXPECT_EQ(centre.grid(110, 205), 12);
}

TEST_F(GridFiles, Points)
{
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 4; ++j) {
      points.push_back({0.1 * i, 100. * j, f(0.1 * i, 100. * j)});
    }
  }
  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  std::string text = "# x y z\n";
  for (auto const& point : points) {
    text += std::to_string(point[0]) + "," + std::to_string(point[1]) + "\t" +
            std::to_string(point[2]) + "\n";
  }
  EXPECT_NEAR(readGrid(write("a.xyz", text)).grid(0.25, 150), f(0.25, 150), 1e-5);
  test::expectRefusal(
    [&] {
      std::string scattered;
      for (int i = 0; i < 20; ++i) {
        scattered += std::to_string(i * i) + " " + std::to_string(i * 7 % 20) + " 1\n";
      }
      readGrid(write("b.xyz", scattered));
    },
    {"b.xyz", "no grid", "gmt surface"});
}

TEST_F(GridFiles, Srtm)
{
  std::string text;
  for (int j = 0; j <= 1200; ++j) {
    for (int i = 0; i <= 1200; ++i) {
      text += bytes(static_cast<std::int16_t>(i == 600 && j == 600 ? -32768 : i - 2 * j), true);
    }
  }
  const auto data = readGrid(write("S02W119.hgt", text));
  EXPECT_EQ(data.horizontal_unit, "degrees");
  EXPECT_EQ(data.vertical_unit, 1);
  EXPECT_NEAR(data.grid(-118.75, -1.25), 300 - 2 * 300, 1e-6); // 0.25 degrees from the north west
  EXPECT_NEAR(data.grid(241, -2), 0 - 2 * 1200, 1e-6);
  test::expectRefusal([&] { data.grid(-118.5, -1.5); }, {"not defined"});
  test::expectRefusal([&] { readGrid(write("N01E003.hgt", text.substr(2))); },
                      {"2884800 bytes", "cut"});
  test::expectRefusal([&] { readGrid(write("dem.hgt", text)); }, {"no corner in its name"});
}

TEST_F(GridFiles, ThatAreDamagedAreRefused)
{
  const auto expectRefused = [&](std::string const& name, std::string const& content,
                                 std::vector<std::string> const& parts) {
    const auto path = write(name, content);
    test::expectRefusal([&] { readGrid(path); }, parts);
  };
  const std::string header = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
  expectRefused("a.asc", header + "1 2 3\n4 5\n", {"a.asc", "cut or damaged"});
  expectRefused("b.asc", header + "1 2 3\n4 5 z\n", {"line 7", "'z'"});
  expectRefused("c.asc", "ncols 4000000000\nnrows 4000000000\ncellsize 1\n1 2\n", {"ncols"});
  expectRefused("d.asc", "ncols 400000\nnrows 400000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n",
                {"is too small for"});
  expectRefused("e.asc", "1 2 3\n", {"no line 'ncols'"});
  expectRefused("f.asc", "ncols 3\nnrows 2\nyllcorner 0\ncellsize 10\n1 2 3 4 5 6\n",
                {"no line 'xllcorner'"});
  expectRefused("a.xyz", "", {"has no point"});
  expectRefused("b.xyz", "1 2\n", {"line 1", "'x y z'"});
  expectRefused("a.tif", "", {"'.tif'", "'.hgt', '.nc'"});
  test::expectRefusal([&] { readGrid(file("a.asc"), "z"); }, {"no variables", "'z'"});
}
