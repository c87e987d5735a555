#pragma once

#include "mesh/SimplexGeometry.hpp"

#include <array>
#include <cmath>

// Vectors in space, along the axes.
namespace asperity::scenario
{
using Vector3 = std::array<double, 3>;

inline double dot(Vector3 const& a, Vector3 const& b) { return mesh::dot<3>(a, b); }

inline double length(Vector3 const& v) { return std::sqrt(dot(v, v)); }

inline Vector3 scaled(Vector3 v, double factor)
{
  for (double& component : v) {
    component *= factor;
  }
  return v;
}

// The part of a vector at right angles to a unit vector.
inline Vector3 partAcross(Vector3 const& v, Vector3 const& unit)
{
  return mesh::difference<3>(v, scaled(unit, dot(v, unit)));
}
} // namespace asperity::scenario
