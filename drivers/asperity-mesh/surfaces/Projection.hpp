#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace asperity::geometry
{
// From longitude and latitude (WGS 84) [degrees] to x to the east and y to the north [m] of a plane
// and back, by the PROJ library.
class Projection
{
public:
  // definition: what PROJ knows ("EPSG:32611", "+proj=tmerc +lat_0=45.5 +lon_0=-122.7"), or "utm11"
  // for zone 11 in the north, "utm11s" in the south. InputError, which starts with `path`, if PROJ
  // refuses the text, if it is no projection to a plane, or if this build has no PROJ.
  Projection(std::string const& definition, std::string const& path);
  ~Projection();
  Projection(Projection&&) noexcept;
  Projection& operator=(Projection&&) noexcept;

  // In place. InputError for a point that cannot be projected.
  void toPlane(std::vector<std::array<double, 3>>& points) const;      // x, y: longitude, latitude
  void toGeographic(std::vector<std::array<double, 3>>& points) const; // z stays

  static bool isAvailable(); // whether this build has PROJ

private:
  struct Transformation;
  std::unique_ptr<Transformation> transformation_;
  std::string where_;
};
} // namespace asperity::geometry
