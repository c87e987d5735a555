#include "tnnmg/FaultColumns.hpp"

#include "portability/Renamed.hpp"

#include <Tpetra_Map.hpp>

namespace asperity::tnnmg
{
namespace
{
NodeView valuesOf(Vector& x)
{
  auto const view = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  return NodeView(view.data(), view.extent(0));
}

ConstNodeView valuesOf(Vector const& x)
{
  auto const view = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
  return ConstNodeView(view.data(), view.extent(0));
}
} // namespace

FaultColumns::FaultColumns(CrsMatrix const& Z, NonlinearNodes const& nodes)
{
  if (Z.getGraph()->getImporter().is_null()) {
    return;
  }
  auto const& owned = *Z.getDomainMap();
  auto const& columns = *Z.getColMap();
  const int num_owned = static_cast<int>(numLocalElements(owned));
  const int num_columns = static_cast<int>(numLocalElements(columns));
  std::vector<GlobalOrdinal> ghosts;
  for (int k = num_owned; k < num_columns; ++k) {
    ghosts.push_back(columns.getGlobalElement(k));
  }
  auto const dofs = toHost(nodes.dofs);
  auto const matrix = Z.getLocalMatrixHost();
  std::vector<char> is_touched(ghosts.size(), 0);
  for (int node = 0; node < nodes.numNodes(); ++node) {
    for (int k = 0; k < nodes.blockSize(); ++k) {
      const int row = dofs(node, k);
      for (auto e = matrix.graph.row_map(row); e < matrix.graph.row_map(row + 1); ++e) {
        if (const int column = matrix.graph.entries(e); column >= num_owned) {
          is_touched[column - num_owned] = 1;
        }
      }
    }
  }
  body_ = GhostExchange(owned, ghosts);
  touched_ = body_.withGhosts(is_touched);
  for (auto const& colour : nodes.colours) {
    std::vector<char> is_of_colour(num_owned, 0);
    auto const of_colour = toHost(colour);
    for (int i = 0; i < of_colour.extent_int(0); ++i) {
      for (int k = 0; k < nodes.blockSize(); ++k) {
        is_of_colour[dofs(of_colour(i), k)] = 1;
      }
    }
    colours_.push_back(touched_.withOwned(is_of_colour));
  }
}

void FaultColumns::shareBody(Vector& columns) const { body_.share<double>(valuesOf(columns)); }

void FaultColumns::share(Vector& columns) const { touched_.share<double>(valuesOf(columns)); }

void FaultColumns::shareColour(std::size_t colour, Vector& columns) const
{
  if (!colours_.empty()) {
    colours_[colour].share<double>(valuesOf(columns));
  }
}

void FaultColumns::subtractGhosts(Vector const& columns, Vector& r) const
{
  touched_.gather<double>(valuesOf(columns), -1, valuesOf(r));
}
} // namespace asperity::tnnmg
