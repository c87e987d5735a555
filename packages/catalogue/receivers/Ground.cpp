#include "catalogue/receivers/Ground.hpp"

#include "base/parallel/Gather.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::catalogue
{
namespace
{
using mesh::cross;
using Vector = Point<3>; // z = 0 in two dimensions

constexpr double infinity = std::numeric_limits<double>::infinity();
// As shares of the size of a facet.
constexpr double reach_beyond = 1e-6; // by which a line may miss it
constexpr double vertical = 1e-9;     // its area seen from above, below which no line meets it

double dot(Vector const& a, Vector const& b) { return mesh::dot<3>(a, b); }

Vector minus(Vector const& a, Vector const& b) { return mesh::difference<3>(a, b); }

// The facet of an element: two corners in the plane, three in space.
struct Facet
{
  std::array<Vector, 3> corners{};
  int dimension = 0;

  Facet(io::OutputDomain const& surface, std::size_t element) : dimension(surface.dimension)
  {
    double const* given =
      &surface.corners[element * static_cast<std::size_t>(dimension * dimension)];
    for (int corner = 0; corner < dimension; ++corner) {
      std::copy_n(given + corner * dimension, dimension, corners[corner].begin());
    }
  }

  Vector edge(int corner) const { return minus(corners[corner], corners[0]); }

  Vector normal() const
  {
    return dimension == 2 ? cross(edge(1), {0, 0, 1}) : cross(edge(1), edge(2));
  }

  // Whether a point of its plane lies in it, up to rounding.
  bool has(Vector const& point, Vector const& n) const
  {
    auto const from_first = minus(point, corners[0]);
    if (dimension == 2) {
      const double weight = dot(from_first, edge(1)) / dot(edge(1), edge(1));
      return weight >= -reach_beyond && weight <= 1 + reach_beyond;
    }
    const double second = dot(cross(from_first, edge(2)), n) / dot(n, n);
    const double third = dot(cross(edge(1), from_first), n) / dot(n, n);
    return second >= -reach_beyond && third >= -reach_beyond && second + third <= 1 + reach_beyond;
  }

  double longestEdge() const
  {
    double longest = 0;
    for (int i = 0; i < dimension; ++i) {
      for (int j = 0; j < i; ++j) {
        longest = std::max(longest, mesh::distance<3>(corners[i], corners[j]));
      }
    }
    return longest;
  }
};

// How far the plane of the facet lies above the point, along up; -infinity outside of the facet.
double riseTo(Facet const& facet, Vector const& point, Vector const& up)
{
  auto const n = facet.normal();
  const double level = dot(n, up);
  if (std::abs(level) <= vertical * std::sqrt(dot(n, n))) {
    return -infinity;
  }
  const double rise = dot(n, minus(facet.corners[0], point)) / level;
  const Vector met = {point[0] + rise * up[0], point[1] + rise * up[1], point[2] + rise * up[2]};
  return facet.has(met, n) ? rise : -infinity;
}
} // namespace

Ground::Ground(io::OutputDomain const& surface, std::array<double, 3> const& up)
    : surface_(surface)
    , up_{up[0], up[1], surface.dimension == 3 ? up[2] : 0}
{
  const double size = std::sqrt(dot(up_, up_));
  up_ = size > 0 ? Vector{up_[0] / size, up_[1] / size, up_[2] / size} : Vector{0, 1, 0};
}

std::optional<int> Ground::verticalAxis() const
{
  for (int d = 0; d < surface_.dimension; ++d) {
    if (std::abs(up_[d]) > 1 - 1e-12) {
      return d;
    }
  }
  return std::nullopt;
}

GroundPoint Ground::highestOfRank(double const* point) const
{
  Vector place{};
  std::copy_n(point, surface_.dimension, place.begin());
  GroundPoint highest{{}, -infinity, 0};
  for (std::size_t element = 0; element < surface_.numOwnedElements(); ++element) {
    const Facet facet(surface_, element);
    const double rise = riseTo(facet, place, up_);
    if (rise > highest.rise) {
      highest.rise = rise;
      highest.element_size = facet.longestEdge();
    }
  }
  return highest;
}

std::vector<std::optional<GroundPoint>> Ground::operator()(std::vector<double> const& points) const
{
  const auto dimension = static_cast<std::size_t>(surface_.dimension);
  const std::size_t num_points = points.size() / dimension;
  std::vector<double> mine; // rise and size of each point
  for (std::size_t i = 0; i < num_points; ++i) {
    auto const highest = highestOfRank(&points[i * dimension]);
    mine.insert(mine.end(), {highest.rise, highest.element_size});
  }
  auto const all = gatherToAll(mine, *surface_.comm);
  std::vector<std::optional<GroundPoint>> result(num_points);
  for (std::size_t i = 0; i < num_points; ++i) {
    GroundPoint highest{{}, -infinity, 0};
    for (std::size_t first = 2 * i; first < all.size(); first += mine.size()) {
      if (all[first] > highest.rise) {
        highest.rise = all[first];
        highest.element_size = all[first + 1];
      }
    }
    if (highest.rise == -infinity) {
      continue;
    }
    for (std::size_t d = 0; d < dimension; ++d) {
      highest.coordinates.push_back(points[i * dimension + d] + highest.rise * up_[d]);
    }
    result[i] = std::move(highest);
  }
  return result;
}

std::optional<Ground> groundOf(std::map<std::string, io::OutputDomain> const& domains,
                               std::array<double, 3> const& up)
{
  auto const surface = domains.find("surface");
  return surface == domains.end() ? std::nullopt : std::make_optional<Ground>(surface->second, up);
}
} // namespace asperity::catalogue
