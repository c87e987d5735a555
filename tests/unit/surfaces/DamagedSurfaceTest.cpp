#include "SurfaceSamples.hpp"

#include "surfaces/SurfaceFile.hpp"

using namespace asperity;
using namespace asperity::geometry;

namespace
{
class DamagedSurface : public FileTest
{
protected:
  void expectRefused(std::string const& name, std::string const& content,
                     std::vector<std::string> parts) const
  {
    const auto path = write(name, content);
    parts.push_back("Surface file '" + path + "'");
    test::expectRefusal([&] { readSurface(path, 1); }, parts);
  }
};

const std::string gocad_begin = "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\n";
const std::string ply_begin = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                              "float y\nproperty float z\nelement face 1\nproperty list uchar int "
                              "vertex_indices\nend_header\n";
} // namespace

TEST_F(DamagedSurface, Gocad)
{
  expectRefused("a.ts", gocad_begin + "TRGL 1 2 4\nEND\n",
                {"line 6", "TRGL names vertex 4", "no line before it defines"});
  expectRefused("b.ts", gocad_begin + "TRGL 1 2 3\n", {"without END", "cut"});
  expectRefused("c.ts", gocad_begin + "VRTX 4 0 nan 0\nEND\n", {"line 6", "finite", "'nan'"});
  expectRefused("d.ts", gocad_begin + "VRTX 4 0 0\nEND\n", {"line 6", "4 words", "VRTX number x"});
  expectRefused("e.ts", gocad_begin + "VRTX 1 0 0 0\nEND\n",
                {"line 6", "vertex 1", "defined twice"});
  expectRefused("f.ts", gocad_begin + "ATOM 5 9\nEND\n", {"line 6", "ATOM names vertex 9"});
  expectRefused("g.ts", gocad_begin + "ZPOSITIVE Down\nEND\n", {"line 6", "'Down'", "Elevation"});
  expectRefused("h.ts", "TFACE\n", {"line 1", "GOCAD TSurf"});
  expectRefused("i.ts", "", {"has no surface"});
  expectRefused("j.ts", gocad_begin + "END\n", {"has no triangle"});
  expectRefused("k.ts", gocad_begin + "TRGL 1 2 2\nEND\n", {"no triangle with an area"});
  expectRefused("l.ts",
                "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT \"m\" \"m\" \"ft\"\n",
                {"line 3", "different units"});
  expectRefused("m.ts", gocad_begin + "TRGL 1 2 3 END", {"without END"});
}

TEST_F(DamagedSurface, Off)
{
  const std::string begin = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  expectRefused("a.off", begin + "3 0 1 3\n", {"line 6", "vertex 3", "[0, 3)"});
  expectRefused("b.off", begin, {"faces", "cut"});
  expectRefused("c.off", begin + "2 0 1\n", {"line 6", "at least 3"});
  expectRefused("d.off", "OFF\n4000000000 4000000000 0\n",
                {"line 2", "4000000000", "allows at most"});
  expectRefused("e.off", "OFF\n3 1 0\n0 0 inf\n", {"line 3", "'inf'"});
  expectRefused("f.off", "FOO\n", {"line 1", "'OFF'"});
  expectRefused("g.off", "OFF\n0 0 0\n", {"has no triangle"});
  expectRefused("h.off", "OFF\n0 -1 0\n", {"line 2", "-1 faces"});
}

TEST_F(DamagedSurface, Stl)
{
  expectRefused("a.stl", std::string(80, ' ') + bytes<std::uint32_t>(4000000000u),
                {"4000000000 triangles", "allows at most 0"});
  expectRefused("b.stl", "short", {"cut"});
  expectRefused("c.stl",
                std::string(80, ' ') + bytes<std::uint32_t>(1) + std::string(12, '\0') +
                  bytes(std::nanf("")) + std::string(34, '\0'),
                {"triangle 0", "not finite"});
  expectRefused("d.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n",
                {"line 5", "1 corners"});
  expectRefused("e.stl", "solid a\nfacet\nouter loop\nvertex 0 0\n", {"line 4", "vertex x y z"});
  expectRefused("f.stl", "solid a\nfacet\n", {"without 'endsolid'"});
  expectRefused("g.stl", "solid a\nhello\n", {"line 2", "'facet'"});
  expectRefused("h.stl", std::string(80, ' ') + bytes<std::uint32_t>(0), {"has no triangle"});
}

TEST_F(DamagedSurface, Obj)
{
  const std::string begin = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectRefused("a.obj", begin + "f 1 2 4\n", {"line 4", "'4'", "3 vertices"});
  expectRefused("b.obj", begin + "f 1 2 0\n", {"line 4", "'0'"});
  expectRefused("c.obj", begin + "f 1 2 -4\n", {"line 4", "'-4'"});
  expectRefused("d.obj", begin + "f 1 2\n", {"line 4", "f vertex vertex vertex"});
  expectRefused("e.obj", begin, {"has no triangle"});
  expectRefused("f.obj", begin + "v 1 2\n", {"line 4", "v x y z"});
}

TEST_F(DamagedSurface, Ply)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  expectRefused("a.ply", ply_begin + points + "3 0 1 3\n", {"line 13", "vertex 3", "[0, 3)"});
  expectRefused("b.ply", ply_begin + points, {"cut"});
  expectRefused("c.ply", ply_begin + points + "2 0 1\n", {"line 13", "fewer than 3"});
  expectRefused("d.ply", "plx\n", {"line 1", "'ply'"});
  expectRefused("e.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty long x\n",
                {"line 4", "'long'"});
  expectRefused("f.ply", "ply\nelement vertex 1\nend_header\n", {"no line 'format'"});
  expectRefused("g.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                "property float x\nproperty float y\nproperty float z\nend_header\n",
                {"4000000000", "'vertex'", "allows at most 0"});
  expectRefused("h.ply",
                "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
                "property float y\nproperty float z\nend_header\n",
                {"4000000000", "too small"});
  expectRefused("i.ply",
                "ply\nformat binary_little_endian 1.0\nelement other 1\nproperty list "
                "uint float x\nend_header\n" +
                  bytes<std::uint32_t>(4000000000u),
                {"count"});
  expectRefused("j.ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n"
                "0\n",
                {"no property x, y or z"});
}

TEST_F(DamagedSurface, Others)
{
  expectRefused("a.dxf", "", {"'.dxf'", "'.obj', '.off', '.ply', '.stl' or '.ts'"});
  expectRefused("a.ply.gz", "\x1f\x8b damaged", {"'"});
  test::expectRefusal([&] { readSurface(file("none.ts"), 1); }, {"none.ts", "Is it there"});
  std::filesystem::create_directory(file("folder.stl"));
  test::expectRefusal([&] { readSurface(file("folder.stl"), 1); }, {"is a folder"});
}

// Each byte in turn by others, and each length: a surface or a message, but nothing else.
TEST_F(DamagedSurface, InEveryByte)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  std::string binary_ply = ply_begin;
  binary_ply.replace(binary_ply.find("ascii"), 5, "binary_little_endian");
  std::string binary_stl = std::string(80, ' ') + bytes<std::uint32_t>(1) + std::string(12, '\0');
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) {
    binary_ply += bytes(x);
    binary_stl += bytes(x);
  }
  binary_ply += bytes<std::uint8_t>(3);
  for (const std::int32_t vertex : {0, 1, 2}) {
    binary_ply += bytes(vertex);
  }
  const std::vector<std::pair<std::string, std::string>> files = {
    {"a.ts", gocad_begin + "TRGL 1 2 3\nEND\n"},
    {"a.off", "OFF\n3 1 0\n" + points + "3 0 1 2\n"},
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"a.stl", "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
              "endfacet\nendsolid\n"},
    {"b.stl", binary_stl + std::string(2, '\0')},
    {"a.ply", ply_begin + points + "3 0 1 2\n"},
    {"b.ply", binary_ply}};
  const auto read = [&](std::string const& name, std::string const& content) {
    try {
      readSurface(write(name, content), 1, "*", [](std::string const&) {});
      return true;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      return false;
    }
  };
  for (auto const& [name, content] : files) {
    EXPECT_TRUE(read(name, content)) << name;
    int num_refused = 0;
    for (std::size_t i = 0; i < content.size(); ++i) {
      num_refused += read(name, content.substr(0, i)) ? 0 : 1;
      for (const char other : {'\xff', '9', '\n'}) {
        std::string damaged = content;
        damaged[i] = other;
        num_refused += read(name, damaged) ? 0 : 1;
      }
    }
    EXPECT_GT(num_refused, static_cast<int>(content.size())) << name;
  }
}
