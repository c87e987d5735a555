#pragma once

#include "assembly/CellShape.hpp"

#include "mesh/GlobalMesh.hpp"

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace asperity::geometry
{
// What convert does with a mesh, in whichever format it was.
struct AssemblyOptions
{
  double scale = 1;              // of coordinates
  bool simplices = false;        // cut other cells into simplices; drop nodes of second order
  std::set<std::string> without; // boundaries and faults to be left out
};

// A mesh as a file of another program has it. Vertices are positions in `vertices`, in the order of
// the file's own numbers.
struct ForeignMesh
{
  struct Cell
  {
    int region;
    int num_corners;
    std::array<int, most_corners> corners; // CellShape.hpp
  };
  using Side = std::array<int, 4>; // of a cell: its corners, -1 behind the last one
  struct Group                     // becomes a boundary or a fault
  {
    std::string name;
    std::vector<Side> sides;
  };

  explicit ForeignMesh(int dimension_of_cells) : dimension(dimension_of_cells) {}

  // The position of the region of this name, which is added if it is new.
  int region(std::string const& name);
  Group& group(std::string const& name); // new or known
  // nodes: positions of vertices, first the corners, then those of second order. number: the
  // file's own, for messages.
  void addCell(int region, std::vector<int> const& nodes, int num_corners, std::int64_t number);
  // The side of a cell that has the corners at these places.
  void addSide(std::string const& group_name, int cell, std::vector<int> const& places);
  // Corners in their order around the side, either way.
  static Side side(std::vector<int> const& corners);

  int dimension;
  std::vector<Point<3>> vertices;
  std::vector<std::int64_t> numbers; // the file's own of vertices; empty if they are positions
  std::vector<Cell> cells;
  std::vector<std::string> region_names;
  std::vector<Group> groups;
  std::vector<std::pair<int, int>> middle_nodes; // cell and vertex: nodes of second order
  std::string first_other; // "hexahedra ..., the first with number 5": what is no linear simplex
};

// The mesh in m, which mesh::checkMesh accepts: of the vertices those that cells have, in their
// order; cells and facets are oriented. A facet that a group has twice, as from both sides of a
// fault, is taken once. A facet inside the body that two groups have stays in the smaller one, and
// a fault of which more than two facets meet is divided into sheets (FaultSheets.hpp); both is
// told. InputError, which starts with `where`, if cells are no linear simplices and are not to be
// cut, a group to be left out is not there, or the mesh is wrong.
template <int Dim>
GlobalMesh<Dim> assemble(ForeignMesh const& mesh, AssemblyOptions const& options,
                         std::string const& where);
} // namespace asperity::geometry
