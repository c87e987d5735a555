#pragma once

#include "base/Text.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string>
#include <vector>

namespace asperity
{
// Number of single-character insertions, deletions, replacements and swaps of neighbours that turn
// one name into the other (optimal string alignment). Upper and lower case count as the same
// letter.
inline std::size_t editDistance(std::string const& left, std::string const& right)
{
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  std::vector<std::size_t> before_last, last(right.size() + 1), row(right.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t(0));
  for (std::size_t i = 1; i <= left.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (same(left[i - 1], right[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped =
        i > 1 && j > 1 && same(left[i - 1], right[j - 2]) && same(left[i - 2], right[j - 1]);
      if (swapped) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
    before_last = last;
    last = row;
  }
  return last.back();
}

// The candidate nearest to the name, or "" if none is similar enough. At most a third of the
// letters may differ, or two letters of a short name.
inline std::string nearestName(std::string const& name, std::vector<std::string> const& candidates)
{
  std::string nearest;
  std::size_t smallest = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (auto const& candidate : candidates) {
    const std::size_t distance = editDistance(name, candidate);
    if (distance < smallest && distance < std::max(name.size(), candidate.size())) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

// The end of a message about an unknown name: " Did you mean 'X'?", or all the valid names.
inline std::string didYouMean(std::string const& name, std::vector<std::string> const& candidates)
{
  const std::string nearest = nearestName(name, candidates);
  if (!nearest.empty()) {
    return " Did you mean '" + nearest + "'?";
  }
  if (candidates.empty()) {
    return " Nothing is expected here.";
  }
  return " Valid names are " + quotedNames(candidates) + ".";
}
} // namespace asperity
