#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::refinement::detail
{
using Edge = std::array<int, 2>;

// The edges of a rank's cells, and others that are given, by their local vertices. The first end is
// the one with the smaller global id. Edges are numbered by the local number of their first end,
// and then by the global id of the other one: those whose first end is owned come first.
template <int Dim>
class PartEdges
{
public:
  // `global_ids` ascend among the owned vertices and among the ghosts, as in Mesh.
  PartEdges(Mesh<Dim> const& part, std::vector<Edge> const& others);

  int size() const { return static_cast<int>(seconds_.size()); }

  // The edges whose first end is this vertex are begin(v) .. begin(v + 1) - 1.
  int begin(int vertex) const { return starts_[static_cast<std::size_t>(vertex)]; }
  int second(int edge) const { return seconds_[static_cast<std::size_t>(edge)]; }

  // The edge between two vertices in any order, or -1.
  int find(int a, int b) const;

private:
  Edge ordered(int a, int b) const { return ids_[a] < ids_[b] ? Edge{a, b} : Edge{b, a}; }
  bool isBefore(int a, int b) const { return ids_[a] < ids_[b]; }

  std::vector<GlobalOrdinal> const& ids_;
  std::vector<int> starts_, seconds_;
};
} // namespace asperity::refinement::detail
