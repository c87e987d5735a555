#pragma once

#include "multigrid/NodeGraph.hpp"

#include <functional>
#include <vector>

namespace asperity::multigrid
{
// How blocks H_i that are added to the finest matrix at some nodes of all ranks (the added blocks)
// act on the nodes of a coarse level that this rank owns: as the sum of Q_i^T H_i Q_i, Q_i the rows
// of the product of all prolongators up to this level. Where it is made.
struct HostAddedBlocks
{
  HostGraph graph; // the nodes that act here, by nodes of the level
  HostBlocks Q;
  // For each such node with n columns the n x n couplings of the level's matrix that its block
  // enters, -1 where another rank owns the row; (num nodes + 1) where they begin.
  std::vector<int> couplings, first;
  std::vector<int> rows; // owned nodes that some block acts on
  // The blocks (num nodes, T, T) that act here, of those at this rank's nodes; null where these
  // are the same, as on one rank. Collective.
  std::function<std::vector<double>(std::vector<double> const&)> collect;
};

// The same where kernels run: for each coupling of the level the products that enter it, so that
// all couplings gather theirs at the same time.
class AddedBlocks
{
public:
  AddedBlocks() = default; // none
  // level: of the level's matrix; order: the places of its couplings where kernels run.
  AddedBlocks(HostAddedBlocks const& host, HostGraph const& level, std::vector<int> const& order);

  IndexView const& rows() const { return rows_; }
  // A += Q^T H Q, for the blocks H (num nodes, T, T) of this rank's nodes. Collective.
  void addTo(NodeBlocks const& A, HessianView const& H) const;

private:
  int tangents_ = 0, motions_ = 0; // T, and the columns of a block of Q
  NodeBlocks Q_;
  IndexView rows_;
  IndexView couplings_;     // those of these rows, of each pair the first one
  IndexView mirrored_;      // the other one of the pair, or -1: itself, or another rank's
  IndexView first_product_; // (num couplings + 1)
  // For each product its node, and the blocks of Q of the coupling's row and column.
  Kokkos::View<const int* [3], Kokkos::LayoutRight, MemorySpace> products_;
  std::function<std::vector<double>(std::vector<double> const&)> collect_;
};
} // namespace asperity::multigrid
