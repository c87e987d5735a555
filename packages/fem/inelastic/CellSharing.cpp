#include "fem/inelastic/CellSharing.hpp"

#include "base/parallel/Directory.hpp"
#include "base/parallel/Messages.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace asperity::fem
{
namespace
{
// The global ids of a cell's vertices, ascending.
template <int Dim>
using Corners = std::array<GlobalOrdinal, Dim + 1>;

template <int Dim>
Corners<Dim> cornersOf(Mesh<Dim> const& mesh, int cell)
{
  Corners<Dim> ids;
  std::transform(mesh.cells[cell].begin(), mesh.cells[cell].end(), ids.begin(),
                 [&](int vertex) { return mesh.global_ids[vertex]; });
  std::sort(ids.begin(), ids.end());
  return ids;
}

template <int Dim>
int leastVertex(Mesh<Dim> const& mesh, int cell)
{
  auto const& vertices = mesh.cells[cell];
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](int a, int b) { return mesh.global_ids[a] < mesh.global_ids[b]; });
}
} // namespace

template <int Dim>
CellSharing::CellSharing(Mesh<Dim> const& mesh, std::vector<int> const& cells,
                         RCP<const Communicator> const& communicator)
    : communicator_(communicator)
{
  std::map<Corners<Dim>, int> owned, ghosts; // the local cells
  for (const int cell : cells) {
    const bool is_owned = leastVertex(mesh, cell) < mesh.num_owned;
    (is_owned ? owned : ghosts).emplace(cornersOf(mesh, cell), cell);
  }

  // In the order of their corners, and so of their least vertices.
  std::map<Corners<Dim>, int> rows;
  std::vector<GlobalOrdinal> least, counts, asked;
  for (auto const& [corners, cell] : owned) {
    rows.emplace(corners, static_cast<int>(cells_.size()));
    cells_.push_back(cell);
    if (least.empty() || least.back() != corners[0]) {
      least.push_back(corners[0]);
      counts.push_back(0);
    }
    ++counts.back();
  }
  const Directory directory(mesh.num_global_vertices, *communicator);
  auto const before = directory.sumsBefore(least, least, counts);
  for (std::size_t i = 0; i < least.size(); ++i) {
    for (GlobalOrdinal k = 0; k < counts[i]; ++k) {
      numbers_.push_back(before[i] + k);
    }
  }

  std::vector<GlobalOrdinal> ids(mesh.global_ids.begin(), mesh.global_ids.begin() + mesh.num_owned);
  for (auto const& [corners, cell] : ghosts) {
    asked.push_back(corners[0]);
  }
  auto const owners =
    directory.valuesAt(asked, ids, std::vector<GlobalOrdinal>(ids.size(), communicator->getRank()));
  // Values will arrive from one rank after the other.
  struct Ghost
  {
    GlobalOrdinal owner;
    Corners<Dim> corners;
    int cell;
  };
  std::vector<Ghost> wanted;
  for (auto const& [corners, cell] : ghosts) {
    wanted.push_back({owners[wanted.size()], corners, cell});
  }
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](Ghost const& a, Ghost const& b) { return a.owner < b.owner; });
  std::vector<long long> questions;
  GhostExchange::Route sent, received;
  for (auto const& ghost : wanted) {
    received.items.push_back(static_cast<int>(cells_.size()));
    received.ranks.push_back(static_cast<int>(ghost.owner));
    cells_.push_back(ghost.cell);
    questions.push_back(communicator->getRank());
    questions.insert(questions.end(), ghost.corners.begin(), ghost.corners.end());
  }
  constexpr std::size_t width = Dim + 2;
  auto const came = sendItems(questions, width, received.ranks, *communicator);
  for (std::size_t i = 0; i < came.size(); i += width) {
    Corners<Dim> corners;
    std::transform(came.begin() + i + 1, came.begin() + i + width, corners.begin(),
                   [](long long id) { return static_cast<GlobalOrdinal>(id); });
    sent.items.push_back(rows.at(corners));
    sent.ranks.push_back(static_cast<int>(came[i]));
  }
  ghosts_ = GhostExchange(communicator, numOwned(), sent, received);
}

std::vector<int> CellSharing::rowsOfMesh(std::size_t num_cells) const
{
  std::vector<int> rows(num_cells, -1);
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    rows[cells_[row]] = static_cast<int>(row);
  }
  return rows;
}

void CellSharing::exchange(BlockView const& values) const
{
  ghosts_.share<double>(NodeView(values.data(), values.size()), values.extent_int(1));
}

template CellSharing::CellSharing(Mesh<2> const&, std::vector<int> const&,
                                  RCP<const Communicator> const&);
template CellSharing::CellSharing(Mesh<3> const&, std::vector<int> const&,
                                  RCP<const Communicator> const&);
} // namespace asperity::fem
