#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace asperity::fem::detail
{
// A velocity that is a sum of coefficients times the velocities of conditions, given by their
// numbers.
using Terms = std::vector<std::pair<int, double>>;

// Whether a unit vector lies along or across another one, or a span of directions, by the cosine of
// the angle between them: along up to an angle of 1.4e-4, across up to 1e-8. Rounding of
// coordinates turns normals by less, about 1e-11 on facets of 1 m in a mesh of 100 km.
inline constexpr double rounding_of_cosine = 1e-8;
inline bool isAlong(double cosine) { return std::abs(1 - std::abs(cosine)) < rounding_of_cosine; }
inline bool isAcross(double cosine) { return std::abs(cosine) < rounding_of_cosine; }

// Orthonormal directions at a node, each with the velocity along it.
class NodalBasis
{
public:
  // Adds the part of the unit vector `direction` that is orthogonal to all others as the next one;
  // `terms` is the velocity along `direction`. Returns false if there is no such part. Then `terms`
  // becomes the difference from the velocity that the others prescribe, which has to be zero.
  bool add(std::vector<double> const& direction, Terms& terms);

  // With empty `terms` the velocity along direction k is free.
  void setVelocity(int k, Terms const& terms) { velocities_[k] = terms; }

  // In two dimensions, turns the second direction to the side of tangentOf(the first one, turn).
  void orient(int turn);

  int size() const { return static_cast<int>(vectors_.size()); }
  std::vector<std::vector<double>> const& vectors() const { return vectors_; }
  Terms const& velocity(int k) const { return velocities_[k]; }

  // The length of the projection of a unit vector onto these directions, and its velocity.
  double share(std::vector<double> const& direction) const;
  Terms velocityAlong(std::vector<double> const& direction) const;

private:
  std::vector<std::vector<double>> vectors_;
  std::vector<Terms> velocities_;
};

double dot(std::vector<double> const& a, std::vector<double> const& b);

// In three dimensions: the part of `towards` at right angles to the unit normal or, if
// `at_right_angles`, the product normal x towards. It is not normalised, and it is zero where
// `towards` is along the normal.
std::vector<double> withinPlane(std::vector<double> const& normal,
                                std::vector<double> const& towards, bool at_right_angles);

// The axis that a unit vector is parallel to, in either direction; -1 if there is none.
int axisOf(std::vector<double> const& direction);

// The unit vector at right angles to orthonormal ones that is nearest to the first axis which is
// far enough from their span. From the normal of a boundary it makes the tangent, which points to
// +x unless the boundary is steep.
std::vector<double> completing(std::vector<std::vector<double>> const& directions, int components);

// The tangent at a node with this unit normal. In two dimensions turn = 1 or -1 says to which side
// of the normal it points, so that all tangents of a bent fault have one sense; turn = 0, and in
// antiplane motion always, it is that of completing().
std::vector<double> tangentOf(std::vector<double> const& normal, int turn);
} // namespace asperity::fem::detail
