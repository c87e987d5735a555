#include "catalogue/receivers/Interpolation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asperity::catalogue
{
namespace
{
using Values = Interpolation::Values;

Values part(Values const& points, int dimension, std::size_t first, std::size_t last)
{
  const auto d = static_cast<std::ptrdiff_t>(dimension);
  return {points.begin() + static_cast<std::ptrdiff_t>(first) * d,
          points.begin() + static_cast<std::ptrdiff_t>(last) * d};
}
} // namespace

Interpolation::Interpolation(io::OutputDomain const& from, Values points, std::string const& run)
    : Interpolation(from, points, points, run)
{
}

Interpolation::Interpolation(io::OutputDomain const& from, Values points, Values searched,
                             std::string const& run)
    : from_(from)
    , location_(from)
    , points_(std::move(points))
    , searched_(std::move(searched))
    , run_(run)
{
}

std::vector<Values> Interpolation::operator()(std::vector<Values> const& fields, int components,
                                              io::Centring centring) const
{
  constexpr std::size_t points_at_once = 4096; // bounds what ranks know of each other's points
  const int rank = from_.comm->getRank(), num_ranks = from_.comm->getSize();
  const std::size_t num_points = points_.size() / static_cast<std::size_t>(from_.dimension);
  std::vector<Values> result(fields.size());
  for (int source_rank = 0; source_rank < num_ranks; ++source_rank) {
    const auto size =
      maxOverRanks(rank == source_rank ? GlobalOrdinal(num_points) : 0, *from_.comm);
    for (std::size_t first = 0; first < static_cast<std::size_t>(size); first += points_at_once) {
      const auto last = std::min(first + points_at_once, static_cast<std::size_t>(size));
      const auto located = rank == source_rank ? find(part(points_, from_.dimension, first, last),
                                                      part(searched_, from_.dimension, first, last))
                                               : find({}, {});
      const Sampling sampling(from_, located, centring);
      for (std::size_t i = 0; i < fields.size(); ++i) {
        auto const values = sampling(fields[i], components);
        if (rank == source_rank) {
          result[i].insert(result[i].end(), values.begin(), values.end());
        }
      }
    }
  }
  return result;
}

// points: of one rank.
std::vector<LocatedPoint> Interpolation::find(Values const& points, Values const& searched) const
{
  constexpr double tolerance = 0.1; // of an element: chords of a curved boundary lie so far apart
  auto const all = gatherToAll(points, *from_.comm);
  auto const located = location_(all, gatherToAll(searched, *from_.comm));
  for (std::size_t i = 0; i < located.size(); ++i) {
    ASPERITY_REQUIRE(located[i].distance <= tolerance * located[i].element_size,
                     "The point " << formatPoint(part(all, from_.dimension, i, i + 1)) << " of the "
                                  << from_.name << " is " << formatShort(located[i].distance)
                                  << " m outside that of the run of --restart-from " << run_
                                  << ", which has no values there. Give both the same extent.");
  }
  return located;
}
} // namespace asperity::catalogue
