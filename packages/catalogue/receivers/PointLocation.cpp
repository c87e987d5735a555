#include "catalogue/receivers/PointLocation.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/NearestPoint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace asperity::catalogue
{
namespace
{
using mesh::NearestPoint;
using mesh::Simplex;

constexpr double rounding = 1e-9; // of the size of an element

// Whether `left` is to be preferred. Distances within rounding count as zero.
bool isNearer(LocatedPoint const& left, LocatedPoint const& right)
{
  const auto apart = [](LocatedPoint const& point) {
    return point.distance <= rounding * point.element_size ? 0 : point.distance;
  };
  if (apart(left) != apart(right)) {
    return apart(left) < apart(right);
  }
  auto mine = left.nodes, other = right.nodes;
  std::sort(mine.begin(), mine.end());
  std::sort(other.begin(), other.end());
  return mine < other;
}

Simplex simplexOf(io::OutputDomain const& domain, std::size_t element)
{
  Simplex simplex{{}, domain.dimension};
  for (int corner = 0; corner < domain.nodes_per_element; ++corner) {
    const std::size_t node = element * domain.nodes_per_element + corner;
    simplex.corners.push_back(&domain.corners[node * domain.dimension]);
  }
  return simplex;
}

LocatedPoint located(io::OutputDomain const& domain, std::size_t element, Simplex const& simplex,
                     double const* point)
{
  NearestPoint nearest = nearestPoint(simplex, point);
  GlobalOrdinal const* nodes = &domain.connectivity[element * domain.nodes_per_element];
  LocatedPoint result{nearest.distance,
                      simplex.longestEdge(),
                      {nodes, nodes + domain.nodes_per_element},
                      nearest.weights,
                      std::vector<double>(domain.dimension, 0)};
  for (int corner = 0; corner < domain.nodes_per_element; ++corner) {
    for (int d = 0; d < domain.dimension; ++d) {
      result.coordinates[d] += nearest.weights[corner] * simplex.corners[corner][d];
    }
  }
  return result;
}

// As numbers, to be sent to the other ranks; node numbers are exact in a double.
std::size_t numNumbers(io::OutputDomain const& domain)
{
  return 2 + 2 * static_cast<std::size_t>(domain.nodes_per_element) +
         static_cast<std::size_t>(domain.dimension);
}

void append(std::vector<double>& numbers, LocatedPoint const& point)
{
  numbers.insert(numbers.end(), {point.distance, point.element_size});
  numbers.insert(numbers.end(), point.nodes.begin(), point.nodes.end());
  numbers.insert(numbers.end(), point.weights.begin(), point.weights.end());
  numbers.insert(numbers.end(), point.coordinates.begin(), point.coordinates.end());
}

LocatedPoint fromNumbers(double const* numbers, io::OutputDomain const& domain)
{
  LocatedPoint point{numbers[0], numbers[1], {}, {}, {}};
  double const* nodes = numbers + 2;
  double const* weights = nodes + domain.nodes_per_element;
  double const* coordinates = weights + domain.nodes_per_element;
  for (double const* node = nodes; node < weights; ++node) {
    point.nodes.push_back(static_cast<GlobalOrdinal>(*node));
  }
  point.weights.assign(weights, coordinates);
  point.coordinates.assign(coordinates, coordinates + domain.dimension);
  return point;
}
} // namespace

PointLocation::PointLocation(io::OutputDomain const& domain) : domain_(domain), tree_(domain)
{
  for (std::size_t element = 0; element < domain.numOwnedElements(); ++element) {
    largest_element_ = std::max(largest_element_, simplexOf(domain, element).longestEdge());
  }
}

LocatedPoint PointLocation::nearestOfRank(double const* point, std::size_t& nearest_element) const
{
  LocatedPoint best;
  best.distance = std::numeric_limits<double>::infinity();
  best.nodes.assign(domain_.nodes_per_element, 0);
  best.weights.assign(domain_.nodes_per_element, 0);
  best.coordinates.assign(domain_.dimension, 0);
  const double margin = rounding * largest_element_;
  tree_.visitNear(point, [&](std::size_t element) {
    LocatedPoint candidate = located(domain_, element, simplexOf(domain_, element), point);
    if (isNearer(candidate, best)) {
      best = std::move(candidate);
      nearest_element = element;
    }
    return best.distance + margin; // elements as near to rounding may have lesser nodes
  });
  return best;
}

std::vector<LocatedPoint> PointLocation::operator()(std::vector<double> const& points) const
{
  return (*this)(points, points);
}

std::vector<LocatedPoint> PointLocation::operator()(std::vector<double> const& points,
                                                    std::vector<double> const& searched) const
{
  constexpr std::size_t most_at_once = 65536; // of all ranks: every rank knows what others found
  const auto num_ranks = static_cast<std::size_t>(domain_.comm->getSize());
  const std::size_t at_once = std::max(most_at_once / num_ranks, std::size_t(1)) *
                              static_cast<std::size_t>(domain_.dimension);
  std::vector<LocatedPoint> result;
  for (std::size_t first = 0; first < points.size(); first += at_once) {
    const auto size = std::min(at_once, points.size() - first);
    locateBatch(&points[first], &searched[first], size, result);
  }
  return result;
}

void PointLocation::locateBatch(double const* points, double const* searched, std::size_t size,
                                std::vector<LocatedPoint>& result) const
{
  std::vector<double> mine;
  for (std::size_t i = 0; i < size; i += domain_.dimension) {
    std::size_t element = 0;
    const auto nearest = nearestOfRank(searched + i, element);
    const bool is_it = points == searched || !std::isfinite(nearest.distance);
    append(mine, nearest);
    append(mine,
           is_it ? nearest : located(domain_, element, simplexOf(domain_, element), points + i));
  }
  const auto all = gatherToAll(mine, *domain_.comm);
  const std::size_t length = numNumbers(domain_), num_points = size / domain_.dimension;
  for (std::size_t point = 0; point < num_points; ++point) {
    const auto of_rank = [&](std::size_t rank, std::size_t which) {
      return fromNumbers(&all[(rank * num_points + point) * 2 * length + which * length], domain_);
    };
    std::size_t best_rank = 0;
    auto best = of_rank(0, 0);
    for (std::size_t rank = 1; rank < all.size() / (2 * length * num_points); ++rank) {
      auto other = of_rank(rank, 0);
      if (isNearer(other, best)) {
        best = std::move(other);
        best_rank = rank;
      }
    }
    result.push_back(of_rank(best_rank, 1));
  }
}

std::vector<LocatedPoint> locate(io::OutputDomain const& domain, std::vector<double> const& points)
{
  return PointLocation(domain)(points);
}

namespace
{
// Of a triangle in space, the leg of a right triangle of the same area: for squares cut in two
// halves this is the side, not the diagonal.
double size(Simplex const& simplex)
{
  if (simplex.numEdges() != 2 || simplex.dimension != 3) {
    return simplex.longestEdge();
  }
  const double mixed = simplex.dot(1, 2);
  return std::pow(simplex.dot(1, 1) * simplex.dot(2, 2) - mixed * mixed, 0.25);
}
} // namespace

double shortestElement(io::OutputDomain const& domain)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t element = 0; element < domain.numOwnedElements(); ++element) {
    shortest = std::min(shortest, size(simplexOf(domain, element)));
  }
  return minOverRanks(shortest, *domain.comm);
}

namespace
{
// The owned elements that may have one of the points, by their nodes.
std::map<std::vector<GlobalOrdinal>, std::size_t>
elementsByNodes(io::OutputDomain const& domain, std::vector<LocatedPoint> const& points)
{
  std::map<std::vector<GlobalOrdinal>, std::size_t> wanted;
  std::set<GlobalOrdinal> first_nodes;
  for (auto const& point : points) {
    first_nodes.insert(point.nodes.front());
  }
  for (std::size_t element = 0; element < domain.numOwnedElements(); ++element) {
    GlobalOrdinal const* nodes = &domain.connectivity[element * domain.nodes_per_element];
    if (first_nodes.count(*nodes) > 0) {
      wanted.emplace(std::vector<GlobalOrdinal>(nodes, nodes + domain.nodes_per_element), element);
    }
  }
  return wanted;
}
} // namespace

Sampling::Sampling(io::OutputDomain const& domain, std::vector<LocatedPoint> const& points,
                   io::Centring centring)
    : comm_(domain.comm)
    , num_points_(points.size())
{
  if (centring == io::Centring::elements) {
    auto const owned = elementsByNodes(domain, points);
    for (std::size_t point = 0; point < points.size(); ++point) {
      const auto element = owned.find(points[point].nodes);
      if (element != owned.end()) {
        terms_.push_back({point, element->second, 1});
      }
    }
  } else {
    std::map<GlobalOrdinal, std::size_t> owned;
    for (std::size_t i = 0; i < domain.numOwned(); ++i) {
      owned[domain.node_numbers[i]] = i;
    }
    for (std::size_t point = 0; point < points.size(); ++point) {
      for (std::size_t corner = 0; corner < points[point].nodes.size(); ++corner) {
        const auto node = owned.find(points[point].nodes[corner]);
        const double weight = points[point].weights[corner];
        if (node != owned.end() && weight > 0) {
          terms_.push_back({point, node->second, weight});
        }
      }
    }
  }
  for (auto const& term : terms_) {
    places_.push_back(term.place);
  }
  std::sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  for (auto& term : terms_) {
    term.place = std::lower_bound(places_.begin(), places_.end(), term.place) - places_.begin();
  }
}

std::vector<double> Sampling::operator()(std::vector<double> const& all, int components) const
{
  std::vector<double> at_places;
  for (const std::size_t place : places_) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(place * components);
    at_places.insert(at_places.end(), first, first + components);
  }
  return fromPlaces(at_places, components);
}

std::vector<double> Sampling::fromPlaces(std::vector<double> const& values, int components) const
{
  std::vector<double> mine(num_points_ * components, 0);
  for (auto const& term : terms_) {
    for (int c = 0; c < components; ++c) {
      mine[term.point * components + c] += term.weight * values[term.place * components + c];
    }
  }
  return sumOverRanks(mine, *comm_);
}
} // namespace asperity::catalogue
