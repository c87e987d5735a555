#include "mesh/parallel/CellGroups.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Directory.hpp"
#include "base/parallel/Messages.hpp"
#include "mesh/SplitVertices.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <unordered_map>

namespace asperity::mesh
{
namespace
{
using Ids = std::vector<GlobalOrdinal>;

template <int Dim>
class Extension
{
public:
  Extension(Mesh<Dim>& mesh, std::vector<int> const& group, Communicator const& communicator)
      : mesh_(mesh)
      , group_(group)
      , communicator_(communicator)
      , directory_(mesh.num_global_vertices, communicator)
  {
    for (std::size_t v = 0; v < mesh.global_ids.size(); ++v) {
      local_.emplace(mesh.global_ids[v], static_cast<int>(v));
    }
  }

  void run()
  {
    auto const cells = cellsOf(foreignGroups());
    addPairs(addVertices(cells));
    std::set<typename Mesh<Dim>::Cell> known;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      if (group_[c] >= mesh_.num_owned) {
        known.insert(sorted(mesh_.cells[c]));
      }
    }
    for (std::size_t row = 0; row < cells.size(); row += cell_width) {
      typename Mesh<Dim>::Cell cell{};
      for (int i = 0; i <= Dim; ++i) {
        cell[i] = local_.at(cells[row + 1 + i]);
      }
      if (known.count(sorted(cell)) == 0) {
        mesh_.cells.push_back(cell);
        mesh_.cell_regions.push_back(static_cast<int>(cells[row + 2 + Dim]));
      }
    }
  }

private:
  static constexpr std::size_t cell_width = 1 + (Dim + 1) + 1; // question, vertices, region
  static constexpr std::size_t pair_width = 1 + 3;             // question, plus, minus, kind

  static typename Mesh<Dim>::Cell sorted(typename Mesh<Dim>::Cell cell)
  {
    std::sort(cell.begin(), cell.end());
    return cell;
  }

  // The vertices of groups that other ranks have as a whole.
  Ids foreignGroups() const
  {
    std::set<GlobalOrdinal> ids;
    for (const int v : group_) {
      if (v >= mesh_.num_owned) {
        ids.insert(mesh_.global_ids[v]);
      }
    }
    return {ids.begin(), ids.end()};
  }

  std::vector<int> ownersOf(Ids const& asked) const
  {
    const Ids mine(mesh_.global_ids.begin(), mesh_.global_ids.begin() + mesh_.num_owned);
    auto const owners = directory_.valuesAt(asked, mine, Ids(mine.size(), communicator_.getRank()));
    return {owners.begin(), owners.end()};
  }

  // Rows of the cells of groups, each with the ids of its vertices.
  Rows cellsOf(Ids const& groups) const
  {
    std::unordered_map<int, std::vector<int>> cells;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      if (group_[c] < mesh_.num_owned) {
        cells[group_[c]].push_back(static_cast<int>(c));
      }
    }
    auto const answer = [&](GlobalOrdinal const* question, Rows& reply) {
      for (const int c : cells.at(local_.at(*question))) {
        for (const int v : mesh_.cells[c]) {
          reply.push_back(mesh_.global_ids[v]);
        }
        reply.push_back(mesh_.cell_regions[c]);
      }
    };
    return ask(groups, 1, ownersOf(groups), cell_width - 1, answer, communicator_);
  }

  // Returns the rows of pairs at the new vertices.
  Rows addVertices(Rows const& cells)
  {
    std::set<GlobalOrdinal> added;
    for (std::size_t row = 0; row < cells.size(); row += cell_width) {
      for (int i = 0; i <= Dim; ++i) {
        if (local_.count(cells[row + 1 + i]) == 0) {
          added.insert(cells[row + 1 + i]);
        }
      }
    }
    const Ids of_cells(added.begin(), added.end());
    auto const pairs =
      ask(of_cells, 1, ownersOf(of_cells), pair_width - 1, pairsAt(), communicator_);
    for (std::size_t row = 0; row < pairs.size(); row += pair_width) {
      added.insert({pairs[row + 1], pairs[row + 2]});
    }
    placeVertices({added.begin(), added.end()});
    return pairs;
  }

  // Answers with all pairs at the place of a vertex, a few at most.
  std::function<void(GlobalOrdinal const*, Rows&)> pairsAt() const
  {
    std::unordered_map<int, std::vector<int>> at; // numbers of the pairs of a vertex
    for (std::size_t i = 0; i < mesh_.splits.size(); ++i) {
      at[mesh_.splits[i].plus].push_back(static_cast<int>(i));
      at[mesh_.splits[i].minus].push_back(static_cast<int>(i));
    }
    return [this, at](GlobalOrdinal const* question, Rows& reply) {
      std::set<int> pairs;
      std::vector<int> open = {local_.at(*question)};
      while (!open.empty()) {
        auto const found = at.find(open.back());
        open.pop_back();
        if (found == at.end()) {
          continue;
        }
        for (const int i : found->second) {
          if (pairs.insert(i).second) {
            open.push_back(mesh_.splits[i].plus);
            open.push_back(mesh_.splits[i].minus);
          }
        }
      }
      for (const int i : pairs) {
        auto const& pair = mesh_.splits[i];
        reply.insert(reply.end(),
                     {mesh_.global_ids[pair.plus], mesh_.global_ids[pair.minus], kindOf(pair)});
      }
    };
  }

  // Vertices with their coordinates, in the order of their ids.
  void placeVertices(Ids const& ids)
  {
    auto const owners = ownersOf(ids);
    std::vector<std::size_t> order(ids.size()); // that of the answers
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return owners[a] < owners[b]; });
    std::vector<long long> questions;
    std::vector<int> to;
    for (const std::size_t i : order) {
      questions.insert(questions.end(), {communicator_.getRank(), ids[i]});
      to.push_back(owners[i]);
    }
    auto const received = sendItems(questions, 2, to, communicator_);
    std::vector<double> places;
    std::vector<int> askers;
    for (std::size_t i = 0; i < received.size(); i += 2) {
      auto const& x = mesh_.vertices[local_.at(static_cast<GlobalOrdinal>(received[i + 1]))];
      places.insert(places.end(), x.begin(), x.end());
      askers.push_back(static_cast<int>(received[i]));
    }
    auto const answers = sendItems(places, Dim, askers, communicator_);
    std::vector<Point<Dim>> of_ids(ids.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      std::copy_n(&answers[i * Dim], Dim, of_ids[order[i]].begin());
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (local_.emplace(ids[i], static_cast<int>(mesh_.vertices.size())).second) {
        mesh_.vertices.push_back(of_ids[i]);
        mesh_.global_ids.push_back(ids[i]);
      }
    }
  }

  void addPairs(Rows const& pairs)
  {
    std::set<int> known;
    for (auto const& pair : mesh_.splits) {
      known.insert(pair.plus);
    }
    for (std::size_t row = 0; row < pairs.size(); row += pair_width) {
      const int plus = local_.at(pairs[row + 1]);
      if (known.insert(plus).second) {
        mesh_.splits.push_back(
          splitVertex(plus, local_.at(pairs[row + 2]), static_cast<int>(pairs[row + 3])));
      }
    }
    std::sort(mesh_.splits.begin(), mesh_.splits.end(),
              [](SplitVertex const& a, SplitVertex const& b) { return a.plus < b.plus; });
  }

  Mesh<Dim>& mesh_;
  std::vector<int> const& group_;
  Communicator const& communicator_;
  Directory directory_;
  std::unordered_map<GlobalOrdinal, int> local_;
};
} // namespace

template <int Dim>
void completeGroups(Mesh<Dim>& mesh, std::vector<int> const& group,
                    Communicator const& communicator)
{
  ASPERITY_ASSERT(group.size() == mesh.cells.size());
  Extension<Dim>(mesh, group, communicator).run();
}

template void completeGroups(Mesh<2>&, std::vector<int> const&, Communicator const&);
template void completeGroups(Mesh<3>&, std::vector<int> const&, Communicator const&);
} // namespace asperity::mesh
