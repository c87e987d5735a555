#include "SurfaceSamples.hpp"

#include "surfaces/Contours.hpp"
#include "surfaces/SurfaceFile.hpp"
#include "surfaces/grids/GridFile.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"

using namespace asperity;
using namespace asperity::geometry;

namespace
{
// Real files of other projects, which are not in the tree.
std::string publicFile(std::string const& name)
{
  return std::string(ASPERITY_PUBLIC_INPUTS) + "/" + name;
}

#define NEEDS(name)                                                                                \
  if (!std::filesystem::exists(publicFile(name))) {                                                \
    GTEST_SKIP() << publicFile(name) << " is not there";                                           \
  }
} // namespace

// A plane of 100 km x 40 km at y = 0, in km.
TEST(PublicFiles, PlaneAsStl)
{
  NEEDS("hbi_bp5t.stl");
  const auto surface = readSurface(publicFile("hbi_bp5t.stl"), 1000);
  EXPECT_EQ(surface.triangles.size(), 9250u);
  EXPECT_NEAR(areaOf(surface) / 1e6, 4000, 1e-3);
  EXPECT_EQ(extentOf(surface, 1), (std::array<double, 2>{0, 0}));
  EXPECT_EQ(extentOf(surface, 2)[1], 0);
  // Euler: a plane without holes has one component and one border.
  const double edges = 3 * 9250 / 2.; // and half of the border's
  EXPECT_GT(double(surface.points.size()), edges - 9250);
  EXPECT_LT(surface.points.size(), 5000u);
}

TEST(PublicFiles, SlabAsClassicNetcdf)
{
  NEEDS("cas_slab1.0_clip.grd");
  const auto data = readGrid(publicFile("cas_slab1.0_clip.grd"));
  EXPECT_NEAR(data.grid(-122.6, 40.22), -52.083054, 1e-3);
  EXPECT_NEAR(data.grid.x().front(), -128.5, 1e-4);
  EXPECT_EQ(data.grid.surface().points.size(), 261051u - 128626u);
}

TEST(PublicFiles, SlabAsNetcdf4)
{
  NEEDS("exp_slab2_dep_06.14.18.grd");
  const auto data = readGrid(publicFile("exp_slab2_dep_06.14.18.grd"));
  const auto surface = data.grid.surface();
  EXPECT_EQ(surface.points.size(), 62901u - 55060u);
  EXPECT_NEAR(extentOf(surface, 2)[0], -307.07510376, 1e-6);
  EXPECT_NEAR(extentOf(surface, 2)[1], -6.1585145, 1e-6);
}

TEST(PublicFiles, SeaFloorAsNetcdf4)
{
  NEEDS("etopo2020_bedrock_local.nc");
  const auto data = readGrid(publicFile("etopo2020_bedrock_local.nc"));
  EXPECT_EQ(data.horizontal_unit, "degrees");
  EXPECT_EQ(data.vertical_unit, 1);
  EXPECT_NEAR(data.grid(-128.5, 49.5), -2370.4045, 1e-3);
  EXPECT_NEAR(data.grid(231.5, 49.5), -2370.4045, 1e-3);
}

// Heights of places from maps.
TEST(PublicFiles, HeightsOfSrtm)
{
  NEEDS("N34W119.hgt");
  const auto data = readGrid(publicFile("N34W119.hgt"));
  EXPECT_NEAR(data.grid(-118.2437, 34.0522), 89, 30);   // Los Angeles
  EXPECT_NEAR(data.grid(-118.0617, 34.2250), 1740, 60); // Mount Wilson
  EXPECT_NEAR(data.grid(-118.8, 34.0), 0, 40);          // the coast
}

// The contours were made from the grid of the same model; 300 m were chosen after the mean distance
// was known, 170 m.
TEST(PublicFiles, ContoursLieOnTheGridOfTheSlab)
{
  NEEDS("cas_contours_dep.in.txt.gz");
  NEEDS("cas_slab1.0_clip.grd");
  const auto grid = readGrid(publicFile("cas_slab1.0_clip.grd")).grid;
  const auto contours = readContours(publicFile("cas_contours_dep.in.txt.gz"));
  EXPECT_EQ(contours.size(), 20u);
  double sum = 0;
  int num_compared = 0;
  for (auto const& contour : contours) {
    for (auto const& point : contour) {
      try {
        sum += std::abs(1000 * (grid(point[0], point[1]) - point[2]));
        ++num_compared;
      } catch (InputError const&) { // at the edge of the slab
      }
    }
  }
  EXPECT_GT(num_compared, 2500);
  EXPECT_LT(sum / num_compared, 300);
}

TEST(PublicFiles, SlabOfContoursLiesOnTheGrid)
{
  NEEDS("cas_contours_dep.in.txt.gz");
  NEEDS("cas_slab1.0_clip.grd");
  if (!Projection::isAvailable()) {
    GTEST_SKIP() << "this build has no PROJ";
  }
  const Projection projection("+proj=tmerc +lat_0=45.52 +lon_0=-122.68 +datum=WGS84", "Projection");
  SurfaceContext context;
  context.projection = &projection;
  context.folder = ASPERITY_PUBLIC_INPUTS;
  const auto make = [&](ParameterList list) {
    Declare declare;
    declareSurface(declare);
    chooseSurfaceType(list, "slab");
    completeAndValidate(list, *declare.list(), "slab");
    return makeSurface(list, "slab", context);
  };
  ParameterList list;
  list.set("Contours File", "cas_contours_dep.in.txt.gz");
  list.set("Units", "degrees");
  list.set("Depth Units", "km");
  list.set("Lower Depth", 60e3);
  list.set("Extend Up", false);
  auto slab = make(list);
  EXPECT_EQ(extentOf(slab, 2), (std::array<double, 2>{-60e3, -5e3}));
  const double area = areaOf(slab);
  list.set("Extend Up", true);
  EXPECT_GT(areaOf(make(list)), area);
  projection.toGeographic(slab.points);
  const auto grid = readGrid(publicFile("cas_slab1.0_clip.grd")).grid;
  double sum = 0;
  int num_compared = 0;
  for (auto const& point : slab.points) {
    try {
      sum += std::abs(1000 * grid(point[0], point[1]) - point[2]);
      ++num_compared;
    } catch (InputError const&) {
    }
  }
  EXPECT_GT(num_compared, 1000);
  EXPECT_LT(sum / num_compared, 300);
  ParameterList of_grid;
  of_grid.set("Grid File", "cas_slab1.0_clip.grd");
  of_grid.set("Units", "degrees");
  of_grid.set("Depth Units", "km");
  of_grid.set("Step", 5e3);
  auto whole = make(of_grid);
  TriangleSurface above; // the same depths
  above.points = whole.points;
  for (auto const& triangle : whole.triangles) {
    bool is_above = true;
    for (const int vertex : triangle) {
      is_above = is_above && whole.points[vertex][2] > -60e3;
    }
    if (is_above) {
      above.triangles.push_back(triangle);
    }
  }
  EXPECT_NEAR(area / areaOf(above), 1, 0.05);
}
