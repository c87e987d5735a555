// A format of surfaces for asperity-mesh: those of the GNU Triangulated Surface Library. After the
// numbers of vertices, edges and faces, a line has the place of a vertex, the two vertices of an
// edge, or the three edges of a face; numbers begin with 1. What is needed is in
// surfaces/files/SurfaceFormat.hpp.
#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/files/TextFile.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace
{
using namespace asperity::geometry;

class Gts final : public SurfaceFormat
{
public:
  std::vector<std::string> endings() const override { return {".gts"}; }

  std::vector<SurfacePart> read(std::string const& file_name) const override
  {
    TextFile file(file_name, "Surface file", '#');
    if (!file.next()) {
      file.fail("the file is empty.");
    }
    file.require(3, "vertices edges faces");
    const std::array<std::int64_t, 3> counts = {file.integer(0), file.integer(1), file.integer(2)};
    std::vector<SurfacePart> parts(1);
    auto& surface = parts.front().surface;
    for (std::int64_t i = 0; i < counts[0]; ++i) {
      requireNext(file, "vertices");
      file.require(3, "x y z");
      surface.points.push_back({file.number(0), file.number(1), file.number(2)});
    }
    std::vector<Edge> edges;
    for (std::int64_t i = 0; i < counts[1]; ++i) {
      requireNext(file, "edges");
      edges.push_back({indexAt(file, 0, surface.points.size(), "vertex"),
                       indexAt(file, 1, surface.points.size(), "vertex")});
    }
    for (std::int64_t i = 0; i < counts[2]; ++i) {
      requireNext(file, "faces");
      surface.triangles.push_back(triangleOf(file, edges));
    }
    return parts;
  }

private:
  using Edge = std::array<int, 2>; // two vertices

  static void requireNext(TextFile& file, std::string const& things)
  {
    if (!file.next()) {
      file.fail("the file ends before all " + things + " are there: it is cut.");
    }
  }

  // From 0, of the number that is word i of the line.
  static int indexAt(TextFile const& file, std::size_t i, std::size_t count,
                     std::string const& thing)
  {
    const auto number = file.integer(i);
    if (number < 1 || number > static_cast<std::int64_t>(count)) {
      file.fail(thing + " " + std::to_string(number) + " is outside [1, " + std::to_string(count) +
                "].");
    }
    return static_cast<int>(number - 1);
  }

  static bool has(Edge const& edge, int vertex) { return edge[0] == vertex || edge[1] == vertex; }

  static std::array<int, 3> triangleOf(TextFile const& file, std::vector<Edge> const& edges)
  {
    std::array<Edge, 3> sides{};
    for (std::size_t i = 0; i < sides.size(); ++i) {
      sides[i] = edges[static_cast<std::size_t>(indexAt(file, i, edges.size(), "edge"))];
    }
    const int middle = has(sides[1], sides[0][0]) ? sides[0][0] : sides[0][1];
    const int first = sides[0][0] + sides[0][1] - middle;
    const int last = sides[1][0] + sides[1][1] - middle;
    const bool are_distinct = first != middle && middle != last && last != first;
    if (!are_distinct || !has(sides[1], middle) || !has(sides[2], first) || !has(sides[2], last)) {
      file.fail("the three edges of a face have to join three vertices.");
    }
    return {first, middle, last};
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceFormatRegistry, "GTS", Gts)
