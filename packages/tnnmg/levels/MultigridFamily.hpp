#pragma once

#include "tnnmg/NonlinearNodes.hpp"
#include "tnnmg/levels/NodeMatrix.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace asperity::tnnmg::detail
{
// How the nonlinear nodes of all ranks act on the nodes of a coarse level that this rank owns:
// their Hessians H_i enter the level's matrix as the sum of Q_i^T H_i Q_i, Q_i the rows of the
// product of all prolongators up to this level.
struct CoarseFault
{
  RCP<const Import> nodes; // from the owned nonlinear nodes to those below; null on one rank
  NodeGraph graph;         // nonlinear nodes by nodes of the level
  NodeBlocks Q;
  // For each nonlinear node with n columns the n x n couplings of the level's matrix that its
  // Hessian enters, -1 where another rank owns the row; (num nodes + 1) where they begin.
  std::vector<int> couplings, first;
  std::vector<int> rows; // owned nodes that some nonlinear node acts on
};

// Makes a matrix. Collective.
using MatrixSource = std::function<RCP<const CrsMatrix>()>;

struct MultigridLevel
{
  NodeGraph graph;                // of the level's matrix
  std::vector<NodeBlocks> terms;  // projected; empty on the finest level
  std::vector<int> before, after; // (num_rows) the end and the beginning of a row's couplings with
                                  // nodes before and after its own
  NodeGraph prolongation;         // from the next level; empty on the coarsest one
  NodeBlocks P;
  CoarseFault fault; // empty on the finest level
};

// How a family is made coarser.
struct Aggregation
{
  Teuchos::ParameterList muelu; // complete, in MueLu's own spelling
  // A coarse level with fewer rows per rank on average moves to fewer ranks; 0: levels stay.
  int rows_per_rank = 0;
};

// The grid transfers of all matrices sum_k w_k A_k with the same terms A_k, and the terms projected
// to the coarse levels. On each level the matrix of any weights is a sum of the terms there, so
// that new weights need neither a Galerkin product nor a set-up by MueLu. The prolongators are
// those of MueLu's smoothed aggregation for the first term.
class MultigridFamily
{
public:
  // The default parameters of the aggregation, in MueLu's own spelling.
  static Teuchos::ParameterList defaults(int components);

  // All terms share the row map, and their couplings are among those of the first one; rows and
  // columns of held dofs are diagonal. They are made one after the other, so that not all are in
  // memory at once. near_null_space is almost zero at rows without off-diagonal entries. fault:
  // local rows of the nonlinear nodes, T each. Throws SolveError if MueLu fails; std::bad_alloc is
  // passed on. Collective.
  MultigridFamily(std::vector<MatrixSource> const& terms, int components,
                  RCP<const MultiVector> const& near_null_space, NodeDofView const& fault,
                  Aggregation const& aggregation);

  std::vector<MultigridLevel> const& levels() const { return levels_; }
  std::size_t bytes() const; // on this rank

private:
  std::vector<MultigridLevel> levels_; // from fine to coarse
};
} // namespace asperity::tnnmg::detail
