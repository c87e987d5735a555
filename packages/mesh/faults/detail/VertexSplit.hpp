#pragma once

#include "mesh/faults/detail/FaultFacets.hpp"
#include "mesh/faults/detail/Star.hpp"

#include <optional>

namespace asperity::mesh::detail
{
// How one vertex of a fault is split.
struct VertexSplit
{
  bool is_cut = false;         // false: the vertex is a tip of all faults there
  std::vector<int> plus_cells; // of the cut
  struct Branch
  {
    std::vector<int> facets;
    bool is_on_plus_side;             // of the cut
    std::vector<int> plus_cells = {}; // of the branch, at a joint; none where it has a tip
  };
  std::vector<Branch> branches; // faults that end at the cut, perhaps on each side of it
  struct Crossing               // of two faults, with the first and second one of mesh::Crossing
  {
    std::array<std::vector<int>, 2> facets;
    std::array<std::vector<int>, 2> plus_cells; // on the plus side of this fault alone
    std::vector<int> both_cells;                // on the plus side of both
  };
  std::optional<Crossing> crossing; // then is_cut, and plus_cells and branches are empty
};

// A vertex of a fault and its surroundings.
template <int Dim>
struct FaultVertex
{
  int number;
  Point<Dim> place;
  std::vector<int> facets;                // of faults, at the vertex
  std::vector<std::array<int, 2>> joined; // of these, as of OrientedFacets
  bool is_on_surface;                     // of the body
  bool is_on_trace; // an edge of these facets through the vertex lies in the surface
};

// InputError, which starts with `where`, if the vertex cannot be split. `facets` are the facets of
// all faults, `names` the names of the faults. has_joints: whether branches may have joints.
template <int Dim>
VertexSplit splitVertex(Star<Dim> const& star, FaultVertex<Dim> const& vertex,
                        std::vector<FaultFacet<Dim>> const& facets,
                        std::vector<std::string> const& names, bool has_joints,
                        std::string const& where);
} // namespace asperity::mesh::detail
