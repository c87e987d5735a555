#include "catalogue/receivers/Interpolation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Gather.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <cstddef>

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

Interpolation::Interpolation(io::OutputDomain const& from, io::OutputDomain const& to,
                             std::string const& run)
    : from_(from)
    , to_(to)
    , location_(from)
    , searched_(to.coordinates)
    , run_(run)
{
}

std::vector<Values> Interpolation::operator()(std::vector<Values> const& fields,
                                              int components) const
{
  constexpr std::size_t points_at_once = 4096; // bounds what ranks know of each other's points
  const int rank = to_.comm->getRank(), num_ranks = to_.comm->getSize();
  std::vector<Values> result(fields.size());
  for (int asking = 0; asking < num_ranks; ++asking) {
    const auto size = maxOverRanks(rank == asking ? GlobalOrdinal(to_.numOwned()) : 0, *to_.comm);
    for (std::size_t first = 0; first < static_cast<std::size_t>(size); first += points_at_once) {
      const auto last = std::min(first + points_at_once, static_cast<std::size_t>(size));
      const auto located = rank == asking ? find(part(to_.coordinates, to_.dimension, first, last),
                                                 part(searched_, to_.dimension, first, last))
                                          : find({}, {});
      const Sampling sampling(from_, located);
      for (std::size_t i = 0; i < fields.size(); ++i) {
        auto const values = sampling(fields[i], components);
        if (rank == asking) {
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
  auto const all = gatherToAll(points, *to_.comm);
  auto const located = location_(all, gatherToAll(searched, *to_.comm));
  for (std::size_t i = 0; i < located.size(); ++i) {
    ASPERITY_REQUIRE(located[i].distance <= tolerance * located[i].element_size,
                     "The point " << formatPoint(part(all, to_.dimension, i, i + 1)) << " of the "
                                  << to_.name << " is " << formatShort(located[i].distance)
                                  << " m outside that of the run of --restart-from " << run_
                                  << ", which has no values there. Give both the same extent.");
  }
  return located;
}
} // namespace asperity::catalogue
