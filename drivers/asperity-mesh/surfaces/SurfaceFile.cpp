#include "surfaces/SurfaceFile.hpp"

#include "surfaces/FileNames.hpp"
#include "surfaces/Weld.hpp"
#include "surfaces/files/SurfaceFormat.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"

#include <algorithm>

namespace asperity::geometry
{
namespace
{
std::vector<SurfacePart> readParts(std::string const& file_name)
{
  auto parts = formatOf<SurfaceFormat>(file_name, "Surface file").read(file_name);
  ASPERITY_REQUIRE(!parts.empty(), "Surface file '" << file_name << "' has no surface.");
  return parts;
}

std::vector<std::string> namesOf(std::vector<SurfacePart> const& parts)
{
  std::vector<std::string> names;
  for (auto const& part : parts) {
    names.push_back(part.name);
  }
  return names;
}

SurfacePart allOf(std::vector<SurfacePart>&& parts)
{
  SurfacePart all = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    auto const& more = parts[i].surface;
    const int first = static_cast<int>(all.surface.points.size());
    all.surface.points.insert(all.surface.points.end(), more.points.begin(), more.points.end());
    for (auto const& triangle : more.triangles) {
      all.surface.triangles.push_back(
        {first + triangle[0], first + triangle[1], first + triangle[2]});
    }
    all.unit = parts[i].unit == all.unit ? all.unit : 0;
    parts[i] = {};
  }
  return all;
}

SurfacePart choose(std::vector<SurfacePart>&& parts, std::string const& name,
                   std::string const& where)
{
  if (name == "*") {
    return allOf(std::move(parts));
  }
  const auto names = namesOf(parts);
  if (name.empty()) {
    ASPERITY_REQUIRE(parts.size() == 1, where << " has " << parts.size()
                                              << " surfaces: " << quotedNames(names)
                                              << ". Name one of them, or '*' for all, by Part.");
    return std::move(parts.front());
  }
  const auto count = std::count(names.begin(), names.end(), name);
  ASPERITY_REQUIRE(count > 0,
                   where << " has no surface '" << name << "'." << didYouMean(name, names));
  ASPERITY_REQUIRE(count == 1, where << " has " << count << " surfaces '" << name
                                     << "'. Give them different names in the file.");
  return std::move(
    parts[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())]);
}
} // namespace

void addPolygon(TriangleSurface& surface, std::vector<int> const& corners)
{
  for (std::size_t i = 2; i < corners.size(); ++i) {
    surface.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

TriangleSurface readSurface(std::string const& file_name, double scale, std::string const& part,
                            RemarkSink const& remark)
{
  std::string where = "Surface file '" + file_name + "'";
  auto chosen = choose(readParts(file_name), part, where);
  if (chosen.unit > 0 && chosen.unit != scale) {
    remark(where + " says that its unit is " + formatNumber(chosen.unit) +
           " m, but it is read with the unit " + formatNumber(scale) + " m.");
  }
  if (!part.empty()) {
    where += ", surface '" + part + "'";
  }
  for (auto& point : chosen.surface.points) {
    for (double& x : point) {
      x *= scale;
    }
  }
  return welded(std::move(chosen.surface), where, remark);
}

std::vector<std::string> partsOfSurface(std::string const& file_name)
{
  return namesOf(readParts(file_name));
}
} // namespace asperity::geometry
