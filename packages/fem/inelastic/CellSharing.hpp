#pragma once

#include "base/Views.hpp"
#include "base/parallel/GhostExchange.hpp"
#include "mesh/Mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity::fem
{
// Some cells of a mesh, each of which one rank owns: that of its vertex of least global id, which
// has all cells of that vertex. The rows of values in cells are first those of owned cells.
class CellSharing
{
public:
  // cells: local ones; on every rank that has it, a cell must be among them or not. Collective.
  template <int Dim>
  CellSharing(Mesh<Dim> const& mesh, std::vector<int> const& cells,
              RCP<const Communicator> const& communicator);

  // The local cell of each row.
  std::vector<int> const& cells() const { return cells_; }
  // (num_cells of the mesh) the row of each local cell, -1 for those that have none.
  std::vector<int> rowsOfMesh(std::size_t num_cells) const;
  int numOwned() const { return static_cast<int>(numbers_.size()); }
  // (num_owned): counted over all ranks from 0, in an order that does not depend on them.
  std::vector<std::int64_t> const& numbers() const { return numbers_; }
  RCP<const Communicator> const& communicator() const { return communicator_; }

  // Sets the rows of cells that other ranks own, values(num_cells, width). Collective.
  void exchange(BlockView const& values) const;

private:
  RCP<const Communicator> communicator_;
  std::vector<int> cells_;
  std::vector<std::int64_t> numbers_;
  GhostExchange ghosts_; // of rows
};
} // namespace asperity::fem
