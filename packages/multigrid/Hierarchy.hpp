#pragma once

#include "multigrid/AddedBlocks.hpp"
#include "multigrid/NodeMatrix.hpp"
#include "multigrid/Schedule.hpp"

#include <functional>
#include <vector>

namespace asperity::multigrid
{
// Sums numbers over the ranks, in place. Collective.
using SumOverRanks = std::function<void(double* values, int count)>;

// A level where it is made.
struct HostLevel
{
  HostGraph graph;               // of the level's matrix
  std::vector<HostBlocks> terms; // projected; empty on the finest level
  HostGraph prolongation;        // from the next level; without rows on the coarsest one
  HostBlocks P;
  HostAddedBlocks added; // empty on the finest level
  // (num_rows) numbers of the nodes among those of all ranks; empty: those of the graph.
  std::vector<int> ids;
};

struct Level
{
  MatrixGraph graph;
  std::vector<NodeBlocks> terms;
  NodeGraph prolongation;
  NodeBlocks P;
  TransposedProduct restriction;
  AddedBlocks added;
  Schedule schedule; // of the rows of the matrix and of the prolongation
  IndexView ids;     // (num_rows)

  // Whether a sweep takes values from before it, from other chunks or ranks.
  bool hasJacobiPart() const { return graph.ghosts.share || schedule.sharesSweeps(); }
};

// The rows of the coarsest level in a matrix of all ranks.
struct CoarsestRows
{
  // More rows make a matrix of gigabytes: aggregates do not cross ranks, so that on many ranks even
  // the coarsest level is large unless levels move to fewer ranks.
  static constexpr int most = 20000;

  int num_rows = 0;        // of all ranks, at most `most`
  std::vector<int> places; // of this rank's columns, ghosts at the end
  SumOverRanks sum;
  SumOverRanks sum_shared; // the same if several ranks have rows, else null
};

// The levels of all matrices sum_k w_k A_k with the same terms A_k, from fine to coarse. On each
// level the matrix of any weights is a sum of the terms there, so that new weights cost no product
// with prolongators.
class Hierarchy
{
public:
  // The levels follow one another, and the columns of a prolongation are the rows of the next level
  // and ghosts.
  Hierarchy(std::vector<HostLevel> levels, CoarsestRows coarsest,
            RowOrder order = defaultRowOrder(), int num_threads = Schedule::numThreads());

  std::vector<Level> const& levels() const { return levels_; }
  CoarsestRows const& coarsest() const { return coarsest_; }

  // The nodes of the finest level are renumbered by their parts: (num_rows) the row of each node;
  // empty if it is the node's own number.
  IndexView const& rowOfNode() const { return row_of_node_; }
  // The blocks of a finest matrix, given in the order of the host's graph.
  NodeBlocks inOrder(HostBlocks const& finest) const;

private:
  std::vector<Level> levels_;
  CoarsestRows coarsest_;
  IndexView row_of_node_;
  std::vector<int> coupling_of_given_; // of the finest matrix
};
} // namespace asperity::multigrid
