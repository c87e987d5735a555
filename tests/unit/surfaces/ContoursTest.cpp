#include "SurfaceSamples.hpp"

#include "surfaces/Contours.hpp"

using namespace asperity;
using namespace asperity::geometry;

namespace
{
using Contours = FileTest;

// Contours of the plane z = -x / 2, 80 km long, in no order, every second one turned round.
std::vector<Polyline> ofPlane()
{
  std::vector<Polyline> contours;
  bool turns = false;
  for (const double z : {-5e3, -20e3, -10e3, -40e3, -15e3}) {
    auto& contour = contours.emplace_back();
    for (int i = 0; i <= 8; ++i) {
      contour.push_back({-2 * z, 10e3 * (turns ? 8 - i : i), z});
    }
    turns = !turns;
  }
  return contours;
}

double offPlane(std::array<double, 3> const& point) { return point[2] + point[0] / 2; }

void refuseRemarks(std::string const& remark) { ADD_FAILURE() << remark; }
} // namespace

TEST(ContourSurface, IsThePlaneOfItsContours)
{
  const auto surface = contourSurface(ofPlane(), {}, "It", refuseRemarks);
  EXPECT_LT(largest(surface, offPlane), 1e-8);
  EXPECT_NEAR(areaOf(surface), 80e3 * 35e3 * std::sqrt(5.), 1);
  EXPECT_EQ(surface.points.size(), 5u * 9u);
}

TEST(ContourSurface, EndsBetweenContoursAndGoesOnUpDip)
{
  ContourOptions options;
  options.lower_z = -30e3;
  options.upper_z = 3e3;
  const auto surface = contourSurface(ofPlane(), options, "It", refuseRemarks);
  EXPECT_LT(largest(surface, offPlane), 1e-8);
  EXPECT_EQ(extentOf(surface, 2), (std::array<double, 2>{-30e3, 3e3}));
  EXPECT_NEAR(areaOf(surface), 80e3 * 33e3 * std::sqrt(5.), 1);
  options.lower_z = -20e3; // that of a contour
  EXPECT_EQ(contourSurface(ofPlane(), options, "It", refuseRemarks).points.size(), 5u * 9u);
  options.lower_z = -41e3;
  test::expectRefusal([&] { contourSurface(ofPlane(), options, "It"); },
                      {"z = -41000 m", "-5000 m down to -40000"});
  options.lower_z = -5e3;
  test::expectRefusal([&] { contourSurface(ofPlane(), options, "It"); }, {"z = -5000 m"});
}

TEST(ContourSurface, HasPointsAtTheSpacing)
{
  ContourOptions options;
  options.spacing = 5e3;
  EXPECT_EQ(contourSurface(ofPlane(), options, "It").points.size(), 5u * 17u);
}

TEST(ContourSurface, JoinsPieces)
{
  auto contours = ofPlane();
  auto& whole = contours[2];
  const Polyline start(whole.begin(), whole.begin() + 3),
    middle(whole.begin() + 3, whole.begin() + 6);
  Polyline end(whole.begin() + 6, whole.end());
  std::reverse(end.begin(), end.end());
  whole = end;
  contours.push_back(start);
  contours.push_back(middle);
  std::string told;
  const auto surface =
    contourSurface(contours, {}, "It", [&](std::string const& remark) { told = remark; });
  EXPECT_NEAR(areaOf(surface), 80e3 * 35e3 * std::sqrt(5.), 1);
  test::expectParts(told, {"z = -10000 m", "3 pieces", "10000 m"});
}

TEST(ContourSurface, IsRefused)
{
  test::expectRefusal([&] { contourSurface({ofPlane()[0]}, {}, "It"); },
                      {"1 depth", "two or more"});
  auto closed = ofPlane();
  closed[1].push_back(closed[1].front());
  test::expectRefusal([&] { contourSurface(closed, {}, "It"); }, {"z = -20000 m", "closed"});
  auto folded = ofPlane(); // converges upward
  for (auto& point : folded[0]) {
    point[1] = 40e3 + 0.5 * (point[1] - 40e3);
  }
  ContourOptions options;
  options.upper_z = 10e3;
  test::expectRefusal([&] { contourSurface(folded, options, "It"); }, {"folded", "Extend Up"});
}

TEST_F(Contours, AreReadInAllForms)
{
  const std::vector<Polyline> wanted = {{{0, 0, -10}, {0, 5, -10}}, {{9, 0, -20}, {9, 5, -20}}};
  EXPECT_EQ(readContours(write("a.txt", "10\n0 0 -10\n0 5 -10\nEND\n20\n9 0 -20\n9 5 -20\nEND\n")),
            wanted);
  EXPECT_EQ(readContours(write("b.txt", "> -Z10\n0 0\n0 5\n> -Z20\n9 0\n9 5\n")), wanted);
  EXPECT_EQ(readContours(write("c.csv", "# lon,lat,depth\n0,0,10\n0,5,10\n9,0,20\n9,5,20\n")),
            wanted);
  EXPECT_EQ(readContours(write("d.txt", "0 0 10\n0 5 10\n\n9 0 20\n9 5 20\n")), wanted);
  EXPECT_EQ(readContours(write("e.txt", "10\n0 0\n0 5\n20\n9 0\n9 5\n")), wanted);
  // by gzip, of the first form
  const char packed[] = "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x33\x34\xe0\x32\x50\x30\x50\xd0"
                        "\x35\x04\xd1\xa6\x60\xda\xd5\xcf\x85\xcb\xc8\x80\xcb\x12\x24\x0c\xa6\x4d"
                        "\xc1\x34\x48\x18\x00\x67\x69\x56\x0d\x2e\x00\x00\x00";
  EXPECT_EQ(readContours(write("a.txt.gz", {packed, sizeof(packed) - 1})), wanted);
  test::expectRefusal(
    [&] {
      readContours(write("b.txt.gz", {packed, sizeof(packed) - 20}));
    },
    {"b.txt.gz", "damaged or cut"});
}

TEST_F(Contours, ThatAreDamagedAreRefused)
{
  const auto expectRefused = [&](std::string const& content,
                                 std::vector<std::string> const& parts) {
    const auto path = write("bad.txt", content);
    test::expectRefusal([&] { readContours(path); }, parts);
  };
  expectRefused("", {"has no contour"});
  expectRefused("0 0\n0 5\n", {"line 1", "'x y z' is expected"});
  expectRefused("0 0 1\n0 5 2\n0 6 3\n", {"line 2", "one point only"});
  expectRefused("0 0 -10\n0 5 -10\n\n0 0 20\n0 5 20\n", {"positive and negative"});
  expectRefused("0 0 -10\n0 x -10\n", {"line 2", "'x'"});
}
