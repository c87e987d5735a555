#include "refinement/detail/CutCells.hpp"

#include "base/parallel/Messages.hpp"

namespace asperity::refinement::detail
{
using mesh::detail::sorted;

template <int Dim>
CutCells<Dim>::CutCells(OwnedPart<Dim> const& coarse, FaultEdges<Dim> const& faults,
                        Points<Dim>& points, Communicator const& communicator)
    : part_(coarse.mesh)
    , points_(points)
{
  if (part_.faults.empty()) { // on all ranks
    return;
  }
  for (auto const& ring : faults.rings()) {
    if (auto const* cut = faults.find(ring.first)) {
      const int point = points.midpoint(cut->plus[0], cut->plus[1]);
      for (int cell : cut->plus_cells) {
        cells_[ring.first].push_back({cell, point});
      }
    }
  }
  queryOwners(coarse, faults, communicator);
}

// A question is a row of Dim + 1 global ids: the two ends of the edge, then the other vertices of
// the cell. The answer is the id of the midpoint that the cell gets; none, if the edge is not cut
// or the cell keeps its own midpoint.
template <int Dim>
void CutCells<Dim>::queryOwners(OwnedPart<Dim> const& coarse, FaultEdges<Dim> const& faults,
                                Communicator const& communicator)
{
  Rows questions;
  std::vector<int> destinations;
  std::vector<std::pair<Edge, int>> asked; // edge and cell
  for (auto const& [edge, cells] : faults.rings()) {
    if (edge[0] < part_.num_owned || edge[1] < part_.num_owned) {
      continue;
    }
    for (int cell : cells) {
      asked.push_back({edge, cell});
      destinations.push_back(coarse.owners[edge[0]]);
      questions.insert(questions.end(), {part_.global_ids[edge[0]], part_.global_ids[edge[1]]});
      for (int vertex : part_.cells[cell]) {
        if (vertex != edge[0] && vertex != edge[1]) {
          questions.push_back(part_.global_ids[vertex]);
        }
      }
    }
  }
  const auto answer = [&](GlobalOrdinal const* ids, Rows& reply) {
    typename Mesh<Dim>::Cell vertices;
    for (int i = 0; i <= Dim; ++i) {
      vertices[i] = localVertex(part_, ids[i]);
    }
    if (auto const* cut = faults.find(sorted(Edge{vertices[0], vertices[1]}))) {
      for (int cell : cut->plus_cells) {
        if (sorted(part_.cells[cell]) == sorted(vertices)) {
          reply.push_back(points_.id(points_.midpoint(cut->plus[0], cut->plus[1])));
        }
      }
    }
  };
  const Rows rows = ask(questions, Dim + 1, destinations, 1, answer, communicator);
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    auto const& [edge, cell] = asked[static_cast<std::size_t>(rows[i])];
    const int twin = points_.midpoint(edge[0], edge[1]);
    cells_[edge].push_back({cell, points_.add(rows[i + 1], twin)});
  }
}

template class CutCells<2>;
template class CutCells<3>;
} // namespace asperity::refinement::detail
