#pragma once

#include "base/parallel/Reductions.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace asperity
{
// The lowest rank on which `holds` is true, on every rank; none if there is none. Collective.
inline std::optional<int> firstRankWhere(bool holds, Communicator const& communicator)
{
  const int none = communicator.getSize();
  const int first = minOverRanks(holds ? communicator.getRank() : none, communicator);
  return first == none ? std::nullopt : std::optional<int>(first);
}

// The numbers of the lowest rank that has some, as of a place, on every rank; none if no rank has
// any. Collective.
template <std::size_t N>
std::optional<std::array<double, N>> ofFirstRank(std::optional<std::array<double, N>> const& mine,
                                                 Communicator const& communicator)
{
  auto const first = firstRankWhere(mine.has_value(), communicator);
  if (!first) {
    return std::nullopt;
  }
  const bool is_here = *first == communicator.getRank();
  return sumOverRanks(is_here ? *mine : std::array<double, N>{}, communicator);
}
} // namespace asperity
