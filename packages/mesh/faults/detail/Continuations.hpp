#pragma once

#include "mesh/faults/detail/FaultFacets.hpp"

#include <map>

namespace asperity::mesh::detail
{
// A ridge is the common part of two facets: a vertex in the plane, an edge in space. Sorted.
template <int Dim>
using Ridge = std::array<int, Dim - 1>;

// Two facets of different faults that are one fault at a ridge.
template <int Dim>
struct Continuation
{
  Ridge<Dim> ridge;
  std::array<int, 2> facets;
};

// Where more than two facets meet, the faults of different names that go on into each other, as
// SplitFaults.hpp says. `ridges` are such ridges with the numbers of their facets, at most two of
// a fault. Ridges that follow one another, with the same faults, are a line: bends are means along
// it, so that all of the line is decided alike.
template <int Dim>
std::vector<Continuation<Dim>> continuations(GlobalMesh<Dim> const& mesh,
                                             std::vector<FaultFacet<Dim>> const& facets,
                                             std::map<Ridge<Dim>, std::vector<int>> const& ridges);
} // namespace asperity::mesh::detail
