#pragma once

#include "mesh/detail/FacetTable.hpp"

namespace asperity::mesh::detail
{
// Throws an InputError that starts with `where` unless the pairs ascend in plus, have vertices in
// [0, num_vertices) and lead from each plus by at most two pairs to a vertex that is the plus of
// none. The minus of a pair may have a larger number than its plus.
void checkNumbersOfPairs(std::vector<SplitVertex> const& splits, std::size_t num_vertices,
                         std::string const& where);

// Throws an InputError that starts with `where` unless the pairs of a mesh that is split, and the
// facets of its faults, are as Mesh describes them. Vertex numbers of cells and facets are in
// range.
template <int Dim>
void checkSplits(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                 std::string const& where);
} // namespace asperity::mesh::detail
