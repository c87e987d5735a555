#include "SurfaceSamples.hpp"

#include "surfaces/SurfaceFile.hpp"
#include "surfaces/Weld.hpp"

using namespace asperity;
using namespace asperity::geometry;

namespace
{
// All files here describe the rectangle 0 <= x <= 2, 0 <= y <= 3 at z = -1, of two triangles.
class SurfaceFile : public FileTest
{
protected:
  void expectRectangle(std::string const& file_name, std::string const& part = "") const
  {
    const auto surface = readSurface(file_name, 1000, part, refuseRemarks);
    EXPECT_EQ(surface.points.size(), 4u) << file_name;
    EXPECT_EQ(surface.triangles.size(), 2u) << file_name;
    EXPECT_DOUBLE_EQ(areaOf(surface), 6e6) << file_name;
    EXPECT_EQ(extentOf(surface, 0), (std::array<double, 2>{0, 2000})) << file_name;
    EXPECT_EQ(extentOf(surface, 1), (std::array<double, 2>{0, 3000})) << file_name;
    EXPECT_EQ(extentOf(surface, 2), (std::array<double, 2>{-1000, -1000})) << file_name;
  }

  static void refuseRemarks(std::string const& remark) { ADD_FAILURE() << remark; }
};

using Triangle = std::array<std::array<float, 3>, 3>;
const std::vector<Triangle> rectangle = {{{{0, 0, -1}, {2, 0, -1}, {2, 3, -1}}},
                                         {{{0, 0, -1}, {2, 3, -1}, {0, 3, -1}}}};

std::string binaryStl(std::string header)
{
  header.resize(80, ' ');
  std::string text = header + bytes<std::uint32_t>(2);
  for (auto const& triangle : rectangle) {
    text += std::string(12, '\0');
    for (auto const& corner : triangle) {
      for (const float x : corner) {
        text += bytes(x);
      }
    }
    text += std::string(2, '\0');
  }
  return text;
}

std::string textStl(std::string const& name)
{
  std::string text = "solid " + name + "\n";
  for (auto const& triangle : rectangle) {
    text += "facet normal 0 0 1\n outer loop\n";
    for (auto const& corner : triangle) {
      text += "  vertex";
      for (const float x : corner) {
        text += " " + std::to_string(x);
      }
      text += "\n";
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

// A second patch repeats two vertices by ATOM; z is a depth.
std::string gocad(std::string const& name, std::string const& header_end)
{
  return "GOCAD TSurf 1\nHEADER {" + header_end + "name:" + name + "\n*solid*color: 1 0 0 1\n}\n" +
         "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\n"
         "AXIS_UNIT \"km\" \"km\" \"km\"\nZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n"
         "PROPERTY_CLASS_HEADER slip {\nname: no name of the surface\n}\n"
         "TFACE\nVRTX 7 0 0 1\nPVRTX 8 2.0e0 0 1 0.5 CNXYZ\nVRTX 9 +2 3 1\nTRGL 7 8 9\n"
         "TFACE\nATOM 10 7\nPATOM 11 9 0.5\nVRTX 12 0 3 1\nTRGL 10 11 12\n"
         "BSTONE 7\nBORDER 13 7 8\nEND\n";
}

std::string ply(std::string const& format)
{
  std::string text = "ply\nformat " + format +
                     " 1.0\ncomment made here\nelement camera 1\nproperty list uchar short "
                     "setting\nelement vertex 4\nproperty double x\nproperty double y\nproperty "
                     "uchar red\nproperty float z\nelement face 1\nproperty list uchar int "
                     "vertex_indices\nproperty uchar flag\nend_header\n";
  if (format == "ascii") {
    return text + "2 5 -5\n0 0 9 -1\n2 0 9 -1\n2 3 9 -1\n0 3 9 -1\n4 0 1 2 3 1\n";
  }
  const bool big = format == "binary_big_endian";
  text += bytes<std::uint8_t>(2) + bytes<std::int16_t>(5, big) + bytes<std::int16_t>(-5, big);
  for (auto const& [x, y] : {std::pair(0., 0.), {2., 0.}, {2., 3.}, {0., 3.}}) {
    text += bytes(x, big) + bytes(y, big) + bytes<std::uint8_t>(9) + bytes<float>(-1, big);
  }
  text += bytes<std::uint8_t>(4);
  for (const std::int32_t vertex : {0, 1, 2, 3}) {
    text += bytes(vertex, big);
  }
  return text + bytes<std::uint8_t>(1);
}
} // namespace

TEST_F(SurfaceFile, Off)
{
  expectRectangle(write("a.off", "OFF # of a rectangle\n4 2 0\n0 0 -1\n2 0 -1\n2 3 -1\n0 3 -1\n"
                                 "3 0 1 2 255 0 0\n3 0 2 3\n"));
  expectRectangle(write("b.OFF", "COFF 4 1 0\r\n0 0 -1 1\r\n2 0 -1 1\r\n2 3 -1 1\r\n0 3 -1 1\r\n"
                                 "4 0 1 2 3"));
}

TEST_F(SurfaceFile, Stl)
{
  expectRectangle(write("text.stl", textStl("plane of the fault")));
  expectRectangle(write("binary.stl", binaryStl("made by a program")));
  expectRectangle(write("trap.stl", binaryStl("solid")));
  const auto two = write("two.stl", textStl("a") + textStl("b"));
  expectRectangle(two, "b");
  test::expectRefusal([&] { readSurface(two, 1); }, {"2 surfaces", "'a', 'b'", "Part"});
}

TEST_F(SurfaceFile, Obj)
{
  expectRectangle(write("a.obj", "# plane\nmtllib x.mtl\nv 0 0 -1\nv 2 0 -1\nv 2 3 -1\nv 0 3 -1\n"
                                 "vn 0 0 1\nf 1//1 2//1 3//1\nf -4 -2 -1\n"));
  const auto groups = write("b.obj", "v 0 0 -1\nv 2 0 -1\ng main\nv 2 3 -1\nv 0 3 -1\nf 1 2 3 4\n"
                                     "g splay\nv 9 9 9\nf 1 2 5\n");
  expectRectangle(groups, "main");
  const auto all = readSurface(groups, 1, "*");
  EXPECT_EQ(all.triangles.size(), 3u);
  EXPECT_EQ(all.points.size(), 5u); // the common ones once
  EXPECT_EQ(partsOfSurface(groups), (std::vector<std::string>{"main", "splay"}));
}

TEST_F(SurfaceFile, Ply)
{
  for (auto const& format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    expectRectangle(write(std::string(format) + ".ply", ply(format)));
  }
}

TEST_F(SurfaceFile, Gocad)
{
  expectRectangle(write("one.ts", gocad("main", "\n")));
  const auto two = write("two.ts", gocad("main", "\n") +
                                     "GOCAD PLine 1\nHEADER {\nname:line\n}\nVRTX 1 0 0 0\nEND\n" +
                                     gocad("splay fault", ""));
  expectRectangle(two, "splay fault");
  EXPECT_EQ(partsOfSurface(two), (std::vector<std::string>{"main", "splay fault"}));
  test::expectRefusal([&] { readSurface(two, 1000); },
                      {"two.ts'", "2 surfaces: 'main', 'splay fault'"});
  test::expectRefusal([&] { readSurface(two, 1000, "splay falt"); },
                      {"no surface 'splay falt'", "Did you mean 'splay fault'?"});
}

TEST_F(SurfaceFile, GocadTellsOfAnotherUnit)
{
  std::string told;
  readSurface(write("one.ts", gocad("main", "")), 1, "",
              [&](std::string const& remark) { told = remark; });
  test::expectParts(told, {"its unit is 1000 m", "read with the unit 1 m"});
}

TEST_F(SurfaceFile, ElevationIsTheDefaultOfGocad)
{
  std::string text = gocad("main", "");
  text.replace(text.find("ZPOSITIVE Depth\n"), 16, "");
  const auto surface = readSurface(write("up.ts", text), 1000);
  EXPECT_EQ(extentOf(surface, 2), (std::array<double, 2>{1000, 1000}));
}

TEST(Weld, LeavesOutWhatHasNoAreaOrIsRepeated)
{
  TriangleSurface given;
  given.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {9, 9, 9}};
  given.triangles = {{0, 1, 2}, {0, 3, 4}, {1, 3, 2}, {2, 3, 0}};
  std::vector<std::string> told;
  const auto surface =
    welded(std::move(given), "It", [&](std::string const& remark) { told.push_back(remark); });
  EXPECT_EQ(surface.points.size(), 3u);
  EXPECT_EQ(surface.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
  ASSERT_EQ(told.size(), 2u);
  test::expectParts(told[0], {"It: 2 triangles of 4 without area"});
  test::expectParts(told[1], {"It: 1 triangle of 4", "three corners"});
}

TEST(Weld, KeepsThinTriangles)
{
  TriangleSurface given;
  given.points = {{0, 0, 0}, {1e5, 0, 0}, {5e4, 1e-3, 0}};
  given.triangles = {{0, 1, 2}};
  EXPECT_EQ(welded(std::move(given), "It", {}).triangles.size(), 1u);
}
