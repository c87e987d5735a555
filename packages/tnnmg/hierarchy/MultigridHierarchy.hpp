#pragma once

#include "base/Views.hpp"
#include "multigrid/Hierarchy.hpp"
#include "tnnmg/hierarchy/NodeGraphs.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace asperity::tnnmg::detail
{
// Makes a matrix. Collective.
using MatrixSource = std::function<RCP<const CrsMatrix>()>;

// How a hierarchy is made coarser.
struct Aggregation
{
  Teuchos::ParameterList muelu; // complete, in MueLu's own spelling
  // A coarse level with fewer rows per rank on average moves to fewer ranks; 0: levels stay.
  int rows_per_rank = 0;
  multigrid::RowOrder row_order = multigrid::defaultRowOrder(); // of sweeps
  bool keeps_prolongators = false;                              // as sparse matrices, too
};

// The levels of all matrices sum_k w_k A_k with the same terms A_k, for a cycle of any weights,
// without a Galerkin product or a set-up by MueLu. The prolongators are those of MueLu's smoothed
// aggregation for the first term.
class MultigridHierarchy
{
public:
  // The default parameters of the aggregation, in MueLu's own spelling.
  static Teuchos::ParameterList defaults(int components);

  // All terms share the row map, and their couplings are among those of the first one; rows and
  // columns of held dofs are diagonal. They are made one after the other, so that not all are in
  // memory at once. near_null_space is almost zero at rows without off-diagonal entries. fault:
  // local rows of the nonlinear nodes, T each. Throws SolveError if MueLu fails or the
  // coarsest level has too many rows; std::bad_alloc is passed on. Collective.
  MultigridHierarchy(std::vector<MatrixSource> const& terms, int components,
                     RCP<const MultiVector> const& near_null_space, NodeDofView const& fault,
                     Aggregation const& aggregation);

  std::vector<multigrid::Level> const& levels() const { return hierarchy_->levels(); }
  std::shared_ptr<const multigrid::Hierarchy> const& shared() const { return hierarchy_; }
  // From that of level 1 on; none unless they are kept.
  std::vector<RCP<const CrsMatrix>> const& prolongators() const { return prolongators_; }
  // The blocks of a matrix with couplings of the terms on the finest level, as its rows have them.
  multigrid::HostBlocks finestBlocks(CrsMatrix const& Z) const;

private:
  std::shared_ptr<const multigrid::Hierarchy> hierarchy_;
  multigrid::HostGraph finest_graph_;
  NodeMaps finest_maps_;
  std::vector<RCP<const CrsMatrix>> prolongators_;
};
} // namespace asperity::tnnmg::detail
