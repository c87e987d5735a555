#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::mesh
{
// Pairs as rows of numbers, as messages, checksums and files have them: plus, minus, 1 for a tip.
using SplitRow = std::array<int, 3>;

inline std::vector<SplitRow> asRows(std::vector<SplitVertex> const& splits)
{
  std::vector<SplitRow> rows;
  for (auto const& pair : splits) {
    rows.push_back({pair.plus, pair.minus, pair.is_tip ? 1 : 0});
  }
  return rows;
}

inline std::vector<SplitVertex> fromRows(std::vector<SplitRow> const& rows)
{
  std::vector<SplitVertex> splits;
  for (auto const& [plus, minus, is_tip] : rows) {
    splits.push_back({plus, minus, is_tip != 0});
  }
  return splits;
}
} // namespace asperity::mesh
