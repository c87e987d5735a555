#include "SurfaceSamples.hpp"

#include "surfaces/kinds/SurfaceKinds.hpp"

#include <Teuchos_XMLParameterListHelpers.hpp>

#include <sstream>

using namespace asperity;
using namespace asperity::geometry;

// The lists that the manual shows, with the files of examples/your_fault, which make_files.py there
// computes by the formulas that stand here again.
namespace
{
const double pi = std::acos(-1.);

std::string manual()
{
  std::ostringstream text;
  text << std::ifstream(std::string(ASPERITY_SOURCE_DIR) + "/docs/reference/surfaces.md").rdbuf();
  return text.str();
}

// The list of that name.
ParameterList shown(std::string const& name)
{
  const std::string page = manual();
  const auto begin = page.find("<ParameterList name=\"" + name + "\">");
  EXPECT_NE(begin, std::string::npos) << name;
  const auto end = page.find("```", begin);
  return *Teuchos::getParametersFromXmlString(page.substr(begin, end - begin));
}

TriangleSurface surfaceShown(std::string const& name, SurfaceContext context = {})
{
  auto list = shown(name);
  context.folder = std::string(ASPERITY_SOURCE_DIR) + "/examples/your_fault";
  context.remark = [](std::string const& remark) { ADD_FAILURE() << remark; };
  Declare declare;
  declareSurface(declare);
  chooseSurfaceType(list, name);
  completeAndValidate(list, *declare.list(), name);
  return makeSurface(list, name, context);
}
} // namespace

TEST(ExampleFiles, Triangles)
{
  const auto splay = surfaceShown("splay");
  EXPECT_EQ(splay.triangles.size(), 2u * 20u * 11u);
  const auto off = [](auto const& p) {
    const double main = 600 * std::sin(2 * pi * 5e3 / 20e3) + 0.05 * p[2];
    return p[0] - (main - 500 + 0.6 * (p[1] - 5e3));
  };
  EXPECT_LT(largest(splay, off), 0.2); // the file has tenths of metres
  EXPECT_EQ(extentOf(splay, 2), (std::array<double, 2>{-15e3, 1500}));
}

TEST(ExampleFiles, Trace)
{
  const auto thrust = surfaceShown("thrust");
  EXPECT_EQ(extentOf(thrust, 2)[0], -12e3);
  EXPECT_NEAR(extentOf(thrust, 2)[1], 600, 1e-9); // 5 % above the flat ground
  // The steepest and the flattest dip, at right angles to the trace.
  double steepest = 0, flattest = 90;
  for (auto const& triangle : thrust.triangles) {
    const auto n = normalOf(thrust, triangle);
    const double dip = std::acos(std::abs(n[2]) / std::hypot(n[0], n[1], n[2])) * 180 / pi;
    steepest = std::max(steepest, dip);
    flattest = std::min(flattest, dip);
    // It dips to the west: the normal that points up points west.
    EXPECT_LT(n[0] * n[2], 0);
  }
  EXPECT_NEAR(steepest, 60, 2);
  EXPECT_NEAR(flattest, 40, 2);
}

TEST(ExampleFiles, Contours)
{
  if (!Projection::isAvailable()) {
    GTEST_SKIP() << "this build has no PROJ";
  }
  const Projection projection("+proj=tmerc +lat_0=38 +lon_0=142 +datum=WGS84", "Projection");
  SurfaceContext context;
  context.projection = &projection;
  auto slab = surfaceShown("slab", context);
  EXPECT_EQ(extentOf(slab, 2)[0], -35e3);
  projection.toGeographic(slab.points);
  const auto off = [](auto const& p) {
    const double depth = 25e3 * (143 + 0.1 * std::sin(2 * (p[1] - 37)) - p[0]);
    return p[2] > -5e3 ? 0 : p[2] + depth;
  };
  EXPECT_LT(largest(slab, off), 100);
}

TEST(ExampleFiles, Ground)
{
  SurfaceContext context;
  context.area = MapArea{{-15e3, -5e3}, {15e3, 30e3}};
  const auto ground = surfaceShown("Ground", context);
  EXPECT_EQ(ground.points.size(), 31u * 36u);
  const auto off = [](auto const& p) {
    return p[2] - (500 + 400 * std::sin(p[0] / 9e3) * std::cos(p[1] / 7e3));
  };
  EXPECT_LT(largest(ground, off), 0.51); // the file has metres
}
