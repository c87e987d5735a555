#pragma once

#include "multigrid/Chunks.hpp"
#include "multigrid/NodeMatrix.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace asperity::multigrid
{
// Sums numbers over the ranks, in place. Collective.
using SumOverRanks = std::function<void(double* values, int count)>;

// How blocks H_i that are added to the finest matrix at some nodes of all ranks (the added blocks)
// act on the nodes of a coarse level that this rank owns: as the sum of Q_i^T H_i Q_i, Q_i the rows
// of the product of all prolongators up to this level.
struct AddedBlocks
{
  NodeGraph graph; // the nodes that act here, by nodes of the level
  NodeBlocks Q;
  // For each such node with n columns the n x n couplings of the level's matrix that its block
  // enters, -1 where another rank owns the row; (num nodes + 1) where they begin.
  std::vector<int> couplings, first;
  std::vector<int> rows; // owned nodes that some block acts on
  // The blocks (num nodes, T, T) that act here, of those at this rank's nodes; empty where these
  // are the same, as on one rank. Collective.
  std::function<std::vector<double>(std::vector<double> const&)> collect;

  // A += Q^T H Q, for the blocks H (num nodes, T, T) of this rank's nodes. Collective.
  void addTo(NodeBlocks& A, std::vector<double> const& H) const;
};

struct Level
{
  NodeGraph graph;                // of the level's matrix
  std::vector<NodeBlocks> terms;  // projected; empty on the finest level
  std::vector<int> before, after; // (num_rows) the end and the beginning of a row's couplings with
                                  // nodes before and after its own
  NodeGraph prolongation;         // from the next level; without rows on the coarsest one
  NodeBlocks P;
  AddedBlocks added; // empty on the finest level
  Chunks chunks;     // of the rows of the matrix and of the prolongation

  // Sets before, after and chunks from the graph.
  void complete(int num_threads = Chunks::numThreads());
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
struct Hierarchy
{
  std::vector<Level> levels;
  CoarsestRows coarsest;
};
} // namespace asperity::multigrid
