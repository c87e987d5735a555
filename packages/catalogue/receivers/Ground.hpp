#pragma once

#include "io/OutputDomain.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// Where the vertical line through a place meets the free surface.
struct GroundPoint
{
  std::vector<double> coordinates; // (dimension) [m]
  double rise = 0;                 // [m] from the place to this point, positive upwards
  double element_size = 0;         // [m] longest edge of the facet that has it
};

// Finds the height of the free surface at places.
class Ground
{
public:
  // surface: the domain of the free surface, which must outlive this object. up: a direction of any
  // length, in two dimensions without its z; +y if nothing is left of it.
  Ground(io::OutputDomain const& surface, std::array<double, 3> const& up);

  // The highest point of the surface on the vertical line through each of the points, (num_points,
  // dimension) [m], which are the same on every rank, as is the result. Empty where the line meets
  // no facet; vertical facets have no point of it. Collective.
  std::vector<std::optional<GroundPoint>> operator()(std::vector<double> const& points) const;

  int dimension() const { return surface_.dimension; }
  // The axis along which up points, in either direction; empty if it points along none.
  std::optional<int> verticalAxis() const;

private:
  // This rank's highest point on the line; rise is -infinity if there is none.
  GroundPoint highestOfRank(double const* point) const;

  io::OutputDomain const& surface_;
  std::array<double, 3> up_{}; // unit vector; z = 0 in two dimensions
};

// The ground of a run with these domains; empty without a free surface. The domains must outlive
// the result.
std::optional<Ground> groundOf(std::map<std::string, io::OutputDomain> const& domains,
                               std::array<double, 3> const& up);
} // namespace asperity::catalogue
