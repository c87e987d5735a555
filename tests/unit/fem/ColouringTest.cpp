#include "fem/Colouring.hpp"

#include "portability/Renamed.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_Map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace asperity::fem
{
namespace
{
using Neighbours = std::function<std::vector<GlobalOrdinal>(GlobalOrdinal)>;

RCP<const Communicator> communicator(MPI_Comm comm) { return rcp(new Teuchos::MpiComm<int>(comm)); }

// Nodes 0 .. num_nodes - 1; rank r owns those whose owner is r modulo the number of ranks.
RCP<const CrsGraph> makeGraph(RCP<const Communicator> const& comm, GlobalOrdinal num_nodes,
                              Neighbours const& neighbours,
                              std::function<int(GlobalOrdinal)> const& owner)
{
  std::vector<GlobalOrdinal> mine;
  for (GlobalOrdinal id = 0; id < num_nodes; ++id) {
    if (owner(id) % comm->getSize() == comm->getRank()) {
      mine.push_back(id);
    }
  }
  const RCP<const Map> map = rcp(new Map(num_nodes, Teuchos::arrayViewFromVector(mine), 0, comm));
  const auto graph = rcp(new CrsGraph(map, 20));
  for (GlobalOrdinal id : mine) {
    graph->insertGlobalIndices(id, Teuchos::arrayViewFromVector(neighbours(id)));
  }
  graph->fillComplete();
  return graph;
}

std::vector<GlobalOrdinal> pathNeighbours(GlobalOrdinal id, GlobalOrdinal num_nodes)
{
  std::vector<GlobalOrdinal> neighbours;
  for (GlobalOrdinal other : {id - 1, id, id + 1}) {
    if (other >= 0 && other < num_nodes) {
      neighbours.push_back(other);
    }
  }
  return neighbours;
}

constexpr GlobalOrdinal lattice_width = 17;

// A square lattice with one diagonal per square, as of a triangulated fault; no self loops.
std::vector<GlobalOrdinal> latticeNeighbours(GlobalOrdinal id)
{
  std::vector<GlobalOrdinal> neighbours;
  const GlobalOrdinal x = id % lattice_width;
  const GlobalOrdinal y = id / lattice_width;
  for (auto [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {1, 1}, {-1, -1}}) {
    if (x + dx >= 0 && x + dx < lattice_width && y + dy >= 0 && y + dy < lattice_width) {
      neighbours.push_back((y + dy) * lattice_width + x + dx);
    }
  }
  return neighbours;
}

// Everybody's colours by global id, summed over the ranks.
std::vector<int> globalColours(CrsGraph const& graph, Colouring const& colouring)
{
  std::vector<int> mine(graph.getGlobalNumRows(), 0);
  for (std::size_t colour = 0; colour < colouring.size(); ++colour) {
    for (LocalOrdinal row : colouring[colour]) {
      mine[graph.getRowMap()->getGlobalElement(row)] = static_cast<int>(colour);
    }
  }
  std::vector<int> all(mine.size(), 0);
  Teuchos::reduceAll(*graph.getComm(), Teuchos::REDUCE_SUM, static_cast<int>(mine.size()),
                     mine.data(), all.data());
  return all;
}

// Colours the graph on all ranks and again on this rank alone; checks that they agree and that no
// edge has one colour. Returns the number of colours.
int checkColouring(GlobalOrdinal num_nodes, Neighbours const& neighbours,
                   std::function<int(GlobalOrdinal)> const& owner)
{
  const auto spread = makeGraph(communicator(MPI_COMM_WORLD), num_nodes, neighbours, owner);
  const auto alone = makeGraph(communicator(MPI_COMM_SELF), num_nodes, neighbours, owner);
  const auto colouring = colourNodes(*spread);
  const auto colours = globalColours(*spread, colouring);
  const auto reference = colourNodes(*alone);

  EXPECT_EQ(colours, globalColours(*alone, reference));
  EXPECT_EQ(colouring.size(), reference.size());
  for (GlobalOrdinal id = 0; id < num_nodes; ++id) {
    for (GlobalOrdinal other : neighbours(id)) {
      EXPECT_TRUE(other == id || colours[id] != colours[other]) << id << " and " << other;
    }
  }
  std::vector<LocalOrdinal> listed;
  for (auto const& rows : colouring) {
    EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
    listed.insert(listed.end(), rows.begin(), rows.end());
  }
  std::sort(listed.begin(), listed.end());
  std::vector<LocalOrdinal> all(numLocalRows(*spread));
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(listed, all);
  return static_cast<int>(colouring.size());
}
} // namespace

TEST(Colouring, PathTakesAtMostThreeColours)
{
  const auto neighbours = [](GlobalOrdinal id) { return pathNeighbours(id, 262); };
  const int in_stretches =
    checkColouring(262, neighbours, [](GlobalOrdinal id) { return static_cast<int>(id / 88); });
  const int in_turns =
    checkColouring(262, neighbours, [](GlobalOrdinal id) { return static_cast<int>(id); });
  EXPECT_LE(in_stretches, 3);
  EXPECT_EQ(in_stretches, in_turns);
}

TEST(Colouring, LatticeTakesAtMostSevenColours)
{
  const auto in_turns = [](GlobalOrdinal id) { return static_cast<int>(id); };
  EXPECT_LE(checkColouring(lattice_width * lattice_width, latticeNeighbours, in_turns), 7);
}

TEST(Colouring, CompleteGraphTakesOneColourPerNode)
{
  const auto neighbours = [](GlobalOrdinal) {
    return std::vector<GlobalOrdinal>{0, 1, 2, 3, 4, 5, 6};
  };
  EXPECT_EQ(
    checkColouring(7, neighbours, [](GlobalOrdinal id) { return static_cast<int>(id % 2); }), 7);
}

TEST(Colouring, UnconnectedNodesShareAColour)
{
  const auto neighbours = [](GlobalOrdinal) { return std::vector<GlobalOrdinal>{}; };
  EXPECT_EQ(checkColouring(11, neighbours, [](GlobalOrdinal) { return 0; }), 1);
}

TEST(Colouring, NoNodesTakeNoColour)
{
  const auto neighbours = [](GlobalOrdinal) { return std::vector<GlobalOrdinal>{}; };
  EXPECT_EQ(checkColouring(0, neighbours, [](GlobalOrdinal) { return 0; }), 0);
}
} // namespace asperity::fem
