#pragma once

#include "mesh/file/PartitionedFile.hpp"

namespace asperity::mesh::detail
{
// The whole mesh, put together from parts that checkPart has accepted.
template <int Dim>
class Assembly
{
public:
  explicit Assembly(PartitionSummary const& summary);

  // Throws InputError unless every cell and facet of the part has a number, and all are in range.
  void add(NumberedPart<Dim> const& part, std::string const& where);

  // Throws InputError unless every vertex, cell and facet has been added.
  GlobalMesh<Dim> finish(std::string const& where);

private:
  void addCells(NumberedPart<Dim> const& part, std::string const& where);
  void addFacets(std::string const& boundary, NumberedPart<Dim> const& part,
                 std::string const& where);
  void addPairs(Mesh<Dim> const& part);

  std::vector<bool> has_vertex_;
  std::map<int, SplitVertex> pairs_; // by the plus vertex
  GlobalMesh<Dim> mesh_;             // cells and facets that are missing have vertices -1
};
} // namespace asperity::mesh::detail
