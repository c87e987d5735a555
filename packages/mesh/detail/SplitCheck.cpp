#include "mesh/detail/SplitCheck.hpp"

#include "base/Errors.hpp"
#include "mesh/Joints.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/SplitVertices.hpp"

namespace asperity::mesh::detail
{
namespace
{
template <int Dim>
void checkPairs(GlobalMesh<Dim> const& mesh, std::string const& where)
{
  checkNumbersOfPairs(mesh.splits, mesh.vertices.size(), where);
  std::vector<bool> is_in_cell(mesh.vertices.size(), false);
  for (auto const& cell : mesh.cells) {
    for (int vertex : cell) {
      is_in_cell[static_cast<std::size_t>(vertex)] = true;
    }
  }
  for (auto const& [plus, minus, is_tip, is_joint] : mesh.splits) {
    ASPERITY_REQUIRE(mesh.vertices[plus] == mesh.vertices[minus],
                     where << ": vertices " << plus << " at " << text(mesh.vertices[plus])
                           << " and " << minus << " at " << text(mesh.vertices[minus])
                           << " are a pair at a fault, but not at one place.");
    ASPERITY_REQUIRE(is_in_cell[plus] != is_tip && is_in_cell[minus],
                     where << ": vertices " << plus << " and " << minus << " at "
                           << text(mesh.vertices[plus])
                           << " are a pair at a fault, but one of them belongs to no cell, or the "
                              "pair is a tip and its first vertex belongs to one.");
  }
  checkCrossings(mesh, where);
  checkJoints(mesh, where);
}

template <int Dim>
void checkFault(GlobalMesh<Dim> const& mesh, std::string const& name, FacetTable<Dim> const& table,
                FaultSides<Dim> const& sides, std::string const& where)
{
  for (auto const& facet : mesh.boundaries.at(name)) {
    const auto describe = [&] {
      return where + ": the facet of fault '" + name + "' at " +
             text(centroid(corners(mesh, facet)));
    };
    for (int vertex : facet) {
      ASPERITY_REQUIRE(sides.find(vertex),
                       describe() << " has vertex " << vertex << ", which is the plus of no pair.");
    }
    const auto on_plus_side = table.find(sides.plusSide(facet));
    const auto on_minus_side = table.find(sides.minusSide(facet));
    ASPERITY_REQUIRE(on_plus_side.first != on_plus_side.second &&
                       on_minus_side.first != on_minus_side.second,
                     describe() << " is not a facet of a cell on both sides.");
  }
}
} // namespace

void checkNumbersOfPairs(std::vector<SplitVertex> const& splits, std::size_t num_vertices,
                         std::string const& where)
{
  const auto is_in_range = [num_vertices](int vertex) {
    return vertex >= 0 && static_cast<std::size_t>(vertex) < num_vertices;
  };
  int before = -1;
  for (auto const& [plus, minus, is_tip, is_joint] : splits) {
    ASPERITY_REQUIRE(plus > before && is_in_range(plus) && is_in_range(minus) && plus != minus,
                     where << ": the pair of vertices " << plus << " and " << minus
                           << " at a fault does not have ascending numbers in [0, " << num_vertices
                           << ").");
    before = plus;
  }
  const FaultPairs pairs(splits);
  for (auto const& pair : splits) {
    auto const* below = pairs.find(pair.minus);
    ASPERITY_REQUIRE(!below || !pairs.find(below->minus),
                     where << ": vertices " << pair.plus << ", " << pair.minus << " and "
                           << below->minus
                           << " are each the plus of a pair at a fault and follow one another. "
                              "Where a branch ends, two pairs may do so, but not three.");
  }
}

template <int Dim>
void checkSplits(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                 std::string const& where)
{
  checkPairs(mesh, where);
  const FaultSides<Dim> sides(mesh);
  for (auto const& name : mesh.faults) {
    ASPERITY_REQUIRE(mesh.boundaries.count(name) > 0,
                     where << ": fault '" << name << "' is not among the boundaries.");
    checkFault(mesh, name, table, sides, where);
  }
}

template void checkSplits(GlobalMesh<2> const&, FacetTable<2> const&, std::string const&);
template void checkSplits(GlobalMesh<3> const&, FacetTable<3> const&, std::string const&);
} // namespace asperity::mesh::detail
