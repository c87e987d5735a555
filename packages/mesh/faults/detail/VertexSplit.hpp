#pragma once

#include "mesh/faults/detail/FaultFacets.hpp"
#include "mesh/faults/detail/VertexStar.hpp"

namespace asperity::mesh::detail
{
// What becomes of one vertex of a fault.
struct VertexSplit
{
  bool is_cut = false;         // or else it is a tip of all faults there
  std::vector<int> plus_cells; // of the cut
  struct Branch
  {
    int fault;
    bool is_on_plus_side; // of the cut
  };
  std::vector<Branch> branches; // faults with a tip at the cut, ascending
};

// What the vertex is part of.
template <int Dim>
struct FaultVertex
{
  Point<Dim> place;
  std::vector<int> facets; // of faults, at the vertex
  bool is_on_surface;      // of the body
  bool is_on_trace;        // an edge of these facets through the vertex lies in the surface
};

// InputError, which starts with `where`, for what cannot be split; `facets` are those of all faults
// and `names` their names.
template <int Dim>
VertexSplit splitVertex(VertexStar<Dim> const& star, FaultVertex<Dim> const& vertex,
                        std::vector<FaultFacet<Dim>> const& facets,
                        std::vector<std::string> const& names, std::string const& where);
} // namespace asperity::mesh::detail
