#include "fem/constraints/VelocityCondition.hpp"

#include "base/Errors.hpp"
#include "fem/constraints/detail/NodalBasis.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem
{
using Components = std::vector<double>;

namespace
{
// Several functions as one, for std::visit: a case for each type of a variant.
template <class... Cases>
struct Overloaded : Cases...
{
  using Cases::operator()...;
};

template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// The square of the sine of the angle between d and the normal below which d has no direction along
// the boundary: an angle of 1e-4, at which rounding of normals turns that direction by 1e-7.
constexpr double least_square_of_sine = 1e-8;

Components normalised(Components vector, std::string const& condition)
{
  const double size = std::sqrt(detail::dot(vector, vector));
  ASPERITY_REQUIRE(size > 0, condition << ": the direction has length zero.");
  for (double& x : vector) {
    x /= size;
  }
  return vector;
}

// In space: the direction of the part of d along the boundary, or the direction along the boundary
// at right angles to d.
template <int Dim>
Components alongBoundary(VelocityCondition<Dim> const& condition, Components const& normal,
                         Components const& d, bool at_right_angles)
{
  ASPERITY_ASSERT(d.size() == 3);
  auto const n = normalised(normal, condition.name);
  auto const tangent = detail::withinPlane(n, d, at_right_angles);
  ASPERITY_REQUIRE(detail::dot(tangent, tangent) > least_square_of_sine * detail::dot(d, d),
                   condition.name << ": the direction (" << d[0] << ", " << d[1] << ", " << d[2]
                                  << ") is perpendicular to the boundary '" << condition.boundary
                                  << "' and has no part along it. Give another direction.");
  return normalised(tangent, condition.name);
}
} // namespace

template <int Dim>
Normal VelocityCondition<Dim>::normal() const
{
  return std::visit([](auto const& one) { return one.normal; }, kind);
}

template <int Dim>
bool VelocityCondition<Dim>::prescribes() const
{
  return std::visit([](auto const& one) { return one.prescribes; }, kind);
}

template <int Dim>
bool VelocityCondition<Dim>::isTurned() const
{
  return std::visit([](auto const& one) { return one.is_turned; }, kind);
}

template <int Dim>
bool VelocityCondition<Dim>::holdsAcross() const
{
  return std::visit([](auto const& one) { return one.holds_across; }, kind);
}

template <int Dim>
double VelocityCondition<Dim>::velocity(Point<Dim> const& x, double t) const
{
  return std::visit([&x, t](auto const& one) -> double { return one.velocity(x, t); }, kind);
}

template <int Dim>
bool VelocityCondition<Dim>::dependsOnTime() const
{
  return std::visit([](auto const& one) { return one.velocity.dependsOnTime(); }, kind);
}

template <int Dim>
Boundaries VelocityCondition<Dim>::boundariesOfNormal() const
{
  auto boundaries =
    std::visit(Overloaded{[](PrescribedVelocity<Dim> const&) { return Boundaries(); },
                          [](AtRestAlong const&) { return Boundaries(); },
                          [](SlidingWall const&) { return Boundaries(); },
                          [](ContactAcrossFault const& one) { return one.continuations; },
                          [](FreeAcrossFault const& one) { return one.continuations; },
                          [](SlipAlongTangent<Dim> const& one) { return one.continuations; },
                          [](SlipTowards<Dim> const& one) { return one.continuations; },
                          [](NoSlipSideways const& one) { return one.continuations; }},
               kind);
  boundaries.push_back(boundary);
  // Sorted, so that boundaries that continue each other sum the facets in the same order, and their
  // normals are equal to the last digit.
  std::sort(boundaries.begin(), boundaries.end());
  boundaries.erase(std::unique(boundaries.begin(), boundaries.end()), boundaries.end());
  return boundaries;
}

template <int Dim>
Components VelocityCondition<Dim>::unitDirection(Components const& inward_normal) const
{
  auto const along = [&](Components const& d) {
    ASPERITY_ASSERT(d.size() == inward_normal.size());
    return normalised(d, name);
  };
  auto const across = [&] { return normalised(inward_normal, name); };
  return std::visit(
    Overloaded{
      [&](PrescribedVelocity<Dim> const& one) { return along(one.d); },
      [&](AtRestAlong const& one) { return along(one.d); },
      [&](SlidingWall const&) { return across(); },
      [&](ContactAcrossFault const&) { return across(); },
      [&](FreeAcrossFault const&) { return across(); },
      [&](SlipAlongTangent<Dim> const&) { return detail::tangentOf(across(), turn); },
      [&](SlipTowards<Dim> const& one) {
        return alongBoundary(*this, inward_normal, one.d, false);
      },
      [&](NoSlipSideways const& one) { return alongBoundary(*this, inward_normal, one.d, true); }},
    kind);
}

template struct VelocityCondition<2>;
template struct VelocityCondition<3>;
} // namespace asperity::fem
