#pragma once

#include "tnnmg/detail/MultigridNodes.hpp"

namespace asperity::tnnmg::detail
{
// Z + H with the excluded nodes' rows and columns reduced to Z's diagonal, for a hierarchy that
// takes friction into account. It has Z's graph, stored zeros included, which a rebuild needs.
class MultigridTruncatedMatrix
{
public:
  // storage is a matrix of Z's graph that is overwritten; if it is null, a copy of Z is made.
  explicit MultigridTruncatedMatrix(RCP<const CrsMatrix> Z, RCP<CrsMatrix> storage = Teuchos::null);

  // excluded(num_nodes) includes all removed nodes.
  void fill(MultigridNodes const& nodes, FlagView const& excluded);

  RCP<const CrsMatrix> matrix() const { return matrix_; }

private:
  RCP<const CrsMatrix> Z_;
  RCP<CrsMatrix> matrix_;
};

// Returns a copy of Z for the first set-up of a hierarchy that will be rebuilt with Hessians. The
// Galerkin products leave out entries that are zero, and a rebuild cannot add entries. So where Z
// does not couple a node's free tangents, which happens on regular meshes, the copy couples them by
// a tiny value; held rows get no coupling. Returns null if no rank has such a node: then Z itself
// serves. Collective.
RCP<CrsMatrix> withCoupledTangents(CrsMatrix const& Z, MultigridNodes const& nodes);
} // namespace asperity::tnnmg::detail
