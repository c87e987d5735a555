#pragma once

#include "tnnmg/detail/MultigridNodes.hpp"

namespace asperity::tnnmg::detail
{
// Z + H with the excluded nodes' rows and columns reduced to Z's diagonal, for a hierarchy that
// takes friction into account. Has Z's graph, zeros included, as a rebuild needs.
class MultigridTruncatedMatrix
{
public:
  // storage: a matrix of Z's graph that is overwritten; null for a copy of Z.
  explicit MultigridTruncatedMatrix(RCP<const CrsMatrix> Z, RCP<CrsMatrix> storage = Teuchos::null);

  // excluded(num_nodes): among them all removed nodes.
  void fill(MultigridNodes const& nodes, FlagView const& excluded);

  RCP<const CrsMatrix> matrix() const { return matrix_; }

private:
  RCP<const CrsMatrix> Z_;
  RCP<CrsMatrix> matrix_;
};

// Z for the first set-up of a hierarchy that is to be rebuilt with Hessians: products leave out
// what is zero, and a rebuild has no place for an entry that the first one did not have. So where
// a node's free tangents are not coupled by Z, which happens on regular meshes, they are by next
// to nothing. Null where there is no such node on any rank: Z itself serves then. Constrained rows
// get no Hessian, and no coupling.
RCP<CrsMatrix> withCoupledTangents(CrsMatrix const& Z, MultigridNodes const& nodes);
} // namespace asperity::tnnmg::detail
