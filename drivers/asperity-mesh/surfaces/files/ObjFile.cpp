#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/files/TextFile.hpp"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Wavefront OBJ: "v x y z", "f a b c" or "f a/t/n ...", numbered from 1, or back from the last
// vertex by negative numbers; "o NAME" and "g NAME" begin a part.
namespace asperity::geometry
{
namespace
{
int corner(TextFile const& file, std::size_t i, std::size_t num_points)
{
  const auto word = file.word(i).substr(0, file.word(i).find('/'));
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const auto count = static_cast<std::int64_t>(num_points);
  if (error != std::errc() || end != word.data() + word.size() || number == 0 || number > count ||
      number < -count) {
    file.fail("'" + std::string(file.word(i)) + "' is not one of the " + std::to_string(count) +
              " vertices before this line.");
  }
  return static_cast<int>(number > 0 ? number - 1 : count + number);
}

// Gives each part the points that it uses.
void distribute(std::vector<SurfacePart>& parts, std::vector<std::array<double, 3>> const& points)
{
  std::vector<int> local(points.size(), -1), used;
  for (auto& part : parts) {
    for (auto& triangle : part.surface.triangles) {
      for (int& vertex : triangle) {
        int& number = local[static_cast<std::size_t>(vertex)];
        if (number < 0) {
          number = static_cast<int>(part.surface.points.size());
          part.surface.points.push_back(points[static_cast<std::size_t>(vertex)]);
          used.push_back(vertex);
        }
        vertex = number;
      }
    }
    for (const int vertex : used) {
      local[static_cast<std::size_t>(vertex)] = -1;
    }
    used.clear();
  }
}

std::vector<SurfacePart> readObj(std::string const& file_name)
{
  TextFile file(file_name, "Surface file", '#');
  std::vector<SurfacePart> parts(1);
  std::vector<std::array<double, 3>> points;
  std::vector<int> corners;
  while (file.next()) {
    auto const key = file.word(0);
    if (key == "v") {
      file.require(4, "v x y z");
      points.push_back({file.number(1), file.number(2), file.number(3)});
    } else if (key == "f") {
      file.require(4, "f vertex vertex vertex");
      corners.clear();
      for (std::size_t i = 1; i < file.words().size(); ++i) {
        corners.push_back(corner(file, i, points.size()));
      }
      addPolygon(parts.back().surface, corners);
    } else if (key == "o" || key == "g") {
      if (!parts.back().surface.triangles.empty()) {
        parts.emplace_back();
      }
      parts.back().name = std::string(file.rest(1));
    }
  }
  if (parts.size() > 1 && parts.back().surface.triangles.empty()) {
    parts.pop_back();
  }
  distribute(parts, points);
  return parts;
}

class Obj final : public SurfaceFormat
{
public:
  std::vector<std::string> endings() const override { return {".obj"}; }
  std::vector<SurfacePart> read(std::string const& file_name) const override
  {
    return readObj(file_name);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceFormatRegistry, "OBJ", Obj)
} // namespace asperity::geometry
