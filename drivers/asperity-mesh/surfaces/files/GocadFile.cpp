#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/files/TextFile.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

// GOCAD TSurf: objects from "GOCAD TSurf" to "END", each with a header, a coordinate system, and
// patches (TFACE) of vertices and triangles. Numbers of vertices are those of the whole object.
namespace asperity::geometry
{
namespace
{
constexpr char const* vertex_form = "VRTX number x y z";

std::string unquoted(std::string_view word)
{
  std::string text(word);
  text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
  return text;
}

double unitOf(std::string const& word, TextFile const& file)
{
  static const std::unordered_map<std::string, double> units = {
    {"m", 1.}, {"M", 1.}, {"km", 1000.}, {"KM", 1000.}, {"ft", 0.3048}, {"feet", 0.3048}};
  const auto found = units.find(word);
  if (found == units.end()) {
    file.fail("AXIS_UNIT '" + word + "' is not a known unit of length; known are m, km and ft.");
  }
  return found->second;
}

class GocadReader
{
public:
  explicit GocadReader(std::string const& file_name) : file_(file_name, "Surface file", '#') {}

  std::vector<SurfacePart> run()
  {
    while (file_.next()) {
      if (file_.word(0) != "GOCAD") {
        file_.fail("'GOCAD TSurf 1' is expected at the beginning of an object.");
      }
      file_.require(2, "GOCAD TSurf 1");
      file_.word(1) == "TSurf" ? readObject() : skipObject();
    }
    return std::move(parts_);
  }

private:
  void requireLine()
  {
    ASPERITY_REQUIRE(file_.next(), file_.where() << " ends within an object, without END: it is "
                                                    "cut.");
  }

  void skipObject()
  {
    do {
      requireLine();
    } while (file_.word(0) != "END");
  }

  void readObject()
  {
    part_ = {};
    numbers_.clear();
    is_depth_ = false;
    for (requireLine(); file_.word(0) != "END"; requireLine()) {
      readLine();
    }
    if (is_depth_) {
      for (auto& point : part_.surface.points) {
        point[2] = -point[2];
      }
    }
    parts_.push_back(std::move(part_));
  }

  void readLine()
  {
    auto const key = file_.word(0);
    if (key == "TRGL") {
      readTriangle();
    } else if (key == "VRTX" || key == "PVRTX") {
      file_.require(5, vertex_form);
      addVertex({file_.number(2), file_.number(3), file_.number(4)});
    } else if (key == "ATOM" || key == "PATOM") {
      file_.require(3, "ATOM number vertex");
      addVertex(part_.surface.points[static_cast<std::size_t>(vertex(2))]);
    } else if (key.substr(0, 6) == "HEADER") {
      readHeader();
    } else if (key == "GOCAD_ORIGINAL_COORDINATE_SYSTEM") {
      readCoordinateSystem();
    } else if (key == "ZPOSITIVE") {
      readDirection();
    }
  }

  // "HEADER {", "name:fault", "}", on one line or several.
  void readHeader()
  {
    bool is_first = true;
    for (bool is_open = true; is_open;) {
      auto line = file_.line();
      if (is_first) {
        line.remove_prefix(std::min(line.size(), line.find('{')));
        line.remove_prefix(line.empty() ? 0 : 1);
        is_first = false;
      }
      is_open = line.find('}') == std::string_view::npos;
      line = line.substr(0, line.find('}'));
      const auto colon = line.find(':');
      if (colon != std::string_view::npos && trim(line.substr(0, colon)) == "name") {
        part_.name = unquoted(trim(line.substr(colon + 1)));
      }
      if (is_open) {
        requireLine();
      }
    }
  }

  static std::string_view trim(std::string_view text)
  {
    constexpr char const* blanks = " \t\r";
    const auto first = text.find_first_not_of(blanks);
    return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(blanks) - first + 1);
  }

  void readCoordinateSystem()
  {
    for (requireLine(); file_.word(0) != "END_ORIGINAL_COORDINATE_SYSTEM"; requireLine()) {
      if (file_.word(0) == "ZPOSITIVE") {
        readDirection();
      } else if (file_.word(0) == "AXIS_UNIT") {
        readUnits();
      }
    }
  }

  void readUnits()
  {
    file_.require(4, "AXIS_UNIT \"m\" \"m\" \"m\"");
    part_.unit = unitOf(unquoted(file_.word(1)), file_);
    for (std::size_t i = 2; i < 4; ++i) {
      if (unitOf(unquoted(file_.word(i)), file_) != part_.unit) {
        file_.fail("the axes have different units. Write all coordinates in one unit.");
      }
    }
  }

  void readDirection()
  {
    file_.require(2, "ZPOSITIVE Elevation");
    const auto word = file_.word(1);
    if (word != "Elevation" && word != "Depth") {
      file_.fail("ZPOSITIVE is '" + std::string(word) + "'; it may be Elevation or Depth.");
    }
    is_depth_ = word == "Depth";
  }

  void addVertex(std::array<double, 3> const& point)
  {
    const auto number = file_.integer(1);
    if (!numbers_.emplace(number, static_cast<int>(part_.surface.points.size())).second) {
      file_.fail("vertex " + std::to_string(number) + " is defined twice.");
    }
    part_.surface.points.push_back(point);
  }

  int vertex(std::size_t i) const
  {
    const auto found = numbers_.find(file_.integer(i));
    if (found == numbers_.end()) {
      file_.fail(std::string(file_.word(0)) + " names vertex " + std::string(file_.word(i)) +
                 ", which no line before it defines.");
    }
    return found->second;
  }

  void readTriangle()
  {
    file_.require(4, "TRGL vertex vertex vertex");
    part_.surface.triangles.push_back({vertex(1), vertex(2), vertex(3)});
  }

  TextFile file_;
  std::vector<SurfacePart> parts_;
  SurfacePart part_;
  std::unordered_map<std::int64_t, int> numbers_;
  bool is_depth_ = false;
};

class Gocad final : public SurfaceFormat
{
public:
  std::vector<std::string> endings() const override { return {".ts"}; }
  std::vector<SurfacePart> read(std::string const& file_name) const override
  {
    return GocadReader(file_name).run();
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceFormatRegistry, "GOCAD TSurf", Gocad)
} // namespace asperity::geometry
