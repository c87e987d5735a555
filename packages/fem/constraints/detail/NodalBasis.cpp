#include "fem/constraints/detail/NodalBasis.hpp"

#include "base/Errors.hpp"
#include "fem/constraints/PlaneTangent.hpp"

#include <cmath>

namespace asperity::fem::detail
{
namespace
{
// A direction depends on others if the sine of its angle to their span is below this: then rounding
// would decide on what is left of it (NodalBasis.hpp has its size).
constexpr double least_sine = 1e-8;
// A component of a unit vector this close to 1 or -1 is one, up to the rounding of its length.
constexpr double rounding_of_axis = 1e-14;

void addScaled(std::vector<double>& a, double factor, std::vector<double> const& b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] += factor * b[i];
  }
}

void addScaled(Terms& terms, double factor, Terms const& others)
{
  for (auto const& [condition, coefficient] : others) {
    terms.emplace_back(condition, factor * coefficient);
  }
}
} // namespace

double dot(std::vector<double> const& a, std::vector<double> const& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

bool NodalBasis::add(std::vector<double> const& direction, Terms& terms)
{
  auto remainder = direction;
  for (int k = 0; k < size(); ++k) {
    const double along = dot(direction, vectors_[k]);
    addScaled(remainder, -along, vectors_[k]);
    addScaled(terms, -along, velocities_[k]);
  }
  const double length = std::sqrt(dot(remainder, remainder));
  if (length < least_sine) {
    return false;
  }
  for (double& x : remainder) {
    x /= length;
  }
  for (auto& term : terms) {
    term.second /= length;
  }
  vectors_.push_back(remainder);
  velocities_.push_back(terms);
  return true;
}

void NodalBasis::orient(int turn)
{
  if (size() != 2 || vectors_[0].size() != 2 ||
      dot(vectors_[1], tangentOf(vectors_[0], turn)) > 0) {
    return;
  }
  for (double& x : vectors_[1]) {
    x = -x;
  }
  for (auto& term : velocities_[1]) {
    term.second = -term.second;
  }
}

double NodalBasis::share(std::vector<double> const& direction) const
{
  double square = 0;
  for (auto const& vector : vectors_) {
    square += dot(direction, vector) * dot(direction, vector);
  }
  return std::sqrt(square);
}

Terms NodalBasis::velocityAlong(std::vector<double> const& direction) const
{
  Terms terms;
  for (int k = 0; k < size(); ++k) {
    const double along = dot(direction, vectors_[k]);
    if (along != 0) {
      addScaled(terms, along, velocities_[k]);
    }
  }
  return terms;
}

std::vector<double> withinPlane(std::vector<double> const& normal,
                                std::vector<double> const& towards, bool at_right_angles)
{
  auto const &n = normal, &d = towards;
  if (at_right_angles) {
    return {n[1] * d[2] - n[2] * d[1], n[2] * d[0] - n[0] * d[2], n[0] * d[1] - n[1] * d[0]};
  }
  const double across = dot(n, d);
  return {d[0] - across * n[0], d[1] - across * n[1], d[2] - across * n[2]};
}

int axisOf(std::vector<double> const& direction)
{
  for (std::size_t i = 0; i < direction.size(); ++i) {
    if (std::abs(std::abs(direction[i]) - 1) < rounding_of_axis) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::vector<double> completing(std::vector<std::vector<double>> const& directions, int components)
{
  for (int axis = 0; axis < components; ++axis) {
    std::vector<double> candidate(components, 0.);
    candidate[axis] = 1;
    for (auto const& known : directions) {
      addScaled(candidate, -dot(candidate, known), known);
    }
    const double length = std::sqrt(dot(candidate, candidate));
    // At least one axis has a longer remainder, since the squares of the lengths of all add up to 1
    // or more.
    if (length > least_remainder) {
      for (double& x : candidate) {
        x /= length;
      }
      return candidate;
    }
  }
  ASPERITY_ASSERT(static_cast<int>(directions.size()) >= components);
  return {};
}

std::vector<double> tangentOf(std::vector<double> const& normal, int turn)
{
  if (normal.size() == 2 && turn != 0) {
    return {turn * normal[1], -turn * normal[0]};
  }
  return completing({normal}, static_cast<int>(normal.size()));
}
} // namespace asperity::fem::detail
