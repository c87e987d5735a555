#include "surfaces/files/BinaryFile.hpp"
#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/files/TextFile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// STL has three points for each triangle, as text or in binary, which is little-endian.
namespace asperity::geometry
{
namespace
{
constexpr std::uint64_t header_size = 80, size_of_triangle = 50;

void addTriangle(TriangleSurface& surface)
{
  const int end = static_cast<int>(surface.points.size());
  surface.triangles.push_back({end - 3, end - 2, end - 1});
}

// "solid NAME", then "facet ...", "outer loop", three "vertex x y z", "endloop", "endfacet".
std::vector<SurfacePart> readText(std::string const& file_name)
{
  TextFile file(file_name, "Surface file");
  std::vector<SurfacePart> parts;
  bool is_open = false;
  int num_corners = 0;
  while (file.next()) {
    auto const key = file.word(0);
    if (key == "solid") {
      parts.emplace_back().name = std::string(file.rest(1));
      is_open = true;
    } else if (!is_open) {
      file.fail("'solid' is expected.");
    } else if (key == "vertex") {
      file.require(4, "vertex x y z");
      parts.back().surface.points.push_back({file.number(1), file.number(2), file.number(3)});
      ++num_corners;
    } else if (key == "endloop") {
      if (num_corners != 3) {
        file.fail("the facet has " + std::to_string(num_corners) + " corners instead of 3.");
      }
      addTriangle(parts.back().surface);
      num_corners = 0;
    } else if (key == "endsolid") {
      is_open = false;
    } else if (key != "facet" && key != "outer" && key != "endfacet") {
      file.fail("'facet', 'outer loop', 'vertex', 'endloop', 'endfacet' or 'endsolid' is "
                "expected.");
    }
  }
  if (is_open) {
    file.fail("the file ends without 'endsolid': it is cut.");
  }
  return parts;
}

std::vector<SurfacePart> readBinary(BinaryFile& file)
{
  file.seek(header_size);
  const auto count = file.number<std::uint32_t>(ByteOrder::little);
  file.requireBytes(count, size_of_triangle, "triangles");
  std::vector<SurfacePart> parts(1);
  auto& surface = parts.front().surface;
  surface.points.reserve(std::size_t(3) * count);
  surface.triangles.reserve(count);
  std::array<char, size_of_triangle> bytes;
  for (std::uint32_t t = 0; t < count; ++t) {
    file.read(bytes.data(), bytes.size());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      auto& point = surface.points.emplace_back();
      for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t at = 4 * (3 * (corner + 1) + d); // behind the normal
        point[d] = fromBytes<float>(&bytes[at], ByteOrder::little);
        if (!std::isfinite(point[d])) {
          file.fail("triangle " + std::to_string(t) + " has a coordinate that is not finite.");
        }
      }
    }
    addTriangle(surface);
  }
  return parts;
}

// Binary files may begin with "solid", too, so the size decides.
std::vector<SurfacePart> readStl(std::string const& file_name)
{
  {
    BinaryFile file(file_name, "Surface file");
    std::array<char, 5> start{};
    file.read(start.data(), std::min<std::uint64_t>(start.size(), file.size()));
    bool is_text = std::string_view(start.data(), start.size()) == "solid";
    if (is_text && file.size() >= header_size + 4) {
      file.seek(header_size);
      const std::uint64_t count = file.number<std::uint32_t>(ByteOrder::little);
      is_text = file.size() != header_size + 4 + count * size_of_triangle;
    }
    if (!is_text) {
      return readBinary(file);
    }
  }
  return readText(file_name);
}

class Stl final : public SurfaceFormat
{
public:
  std::vector<std::string> endings() const override { return {".stl"}; }
  std::vector<SurfacePart> read(std::string const& file_name) const override
  {
    return readStl(file_name);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceFormatRegistry, "STL", Stl)
} // namespace asperity::geometry
