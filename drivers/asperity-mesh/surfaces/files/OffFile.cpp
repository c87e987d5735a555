#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/files/TextFile.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// OFF: "OFF", counts of vertices, faces and edges, then lines "x y z ..." and "n v1 ... vn ...".
namespace asperity::geometry
{
namespace
{
std::size_t countAt(TextFile const& file, std::size_t i, std::uint64_t bytes_each,
                    char const* things)
{
  const auto count = file.integer(i);
  const auto capacity = static_cast<std::int64_t>(file.size() / bytes_each);
  if (count < 0 || count > capacity) {
    file.fail("the file names " + std::to_string(count) + " " + things +
              ", but its size allows at most " + std::to_string(capacity) + ".");
  }
  return static_cast<std::size_t>(count);
}

void requireLine(TextFile& file, char const* things)
{
  if (!file.next()) {
    file.fail("the file ends before all " + std::string(things) + " are there: it is cut.");
  }
}

std::vector<SurfacePart> readOff(std::string const& file_name)
{
  TextFile file(file_name, "Surface file", '#');
  requireLine(file, "counts");
  const std::string key(file.word(0));
  if (key != "OFF" && key != "COFF" && key != "NOFF" && key != "CNOFF") {
    file.fail("'OFF' is expected at the beginning.");
  }
  const std::size_t at = file.words().size() > 1 ? 1 : 0; // counts may follow on the first line
  if (at == 0) {
    requireLine(file, "counts");
  }
  file.require(at + 2, "vertices faces edges");
  const std::size_t num_points = countAt(file, at, 6, "vertices");
  const std::size_t num_faces = countAt(file, at + 1, 8, "faces");
  std::vector<SurfacePart> parts(1);
  auto& surface = parts.front().surface;
  surface.points.reserve(num_points);
  for (std::size_t i = 0; i < num_points; ++i) {
    requireLine(file, "vertices");
    file.require(3, "x y z");
    surface.points.push_back({file.number(0), file.number(1), file.number(2)});
  }
  std::vector<int> corners;
  for (std::size_t i = 0; i < num_faces; ++i) {
    requireLine(file, "faces");
    const auto count = file.integer(0);
    if (count < 3 || file.words().size() <= static_cast<std::size_t>(count)) {
      file.fail("the number of corners, at least 3, and as many vertices are expected.");
    }
    corners.clear();
    for (std::size_t c = 1; c <= static_cast<std::size_t>(count); ++c) {
      const auto vertex = file.integer(c);
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(num_points)) {
        file.fail("vertex " + std::to_string(vertex) + " is outside [0, " +
                  std::to_string(num_points) + ").");
      }
      corners.push_back(static_cast<int>(vertex));
    }
    addPolygon(surface, corners);
  }
  return parts;
}

class Off final : public SurfaceFormat
{
public:
  std::vector<std::string> endings() const override { return {".off"}; }
  std::vector<SurfacePart> read(std::string const& file_name) const override
  {
    return readOff(file_name);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceFormatRegistry, "OFF", Off)
} // namespace asperity::geometry
