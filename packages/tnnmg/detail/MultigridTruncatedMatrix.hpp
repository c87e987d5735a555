#pragma once

#include "tnnmg/detail/MultigridNodes.hpp"

namespace asperity::tnnmg::detail
{
// Z + H with the excluded nodes' rows and columns reduced to Z's diagonal, for a hierarchy that
// takes friction into account. Has Z's graph, zeros included, as a rebuild needs.
class MultigridTruncatedMatrix
{
public:
  explicit MultigridTruncatedMatrix(RCP<const CrsMatrix> Z);

  // excluded(num_nodes): among them all removed nodes.
  void fill(MultigridNodes const& nodes, FlagView const& excluded);

  RCP<const CrsMatrix> matrix() const { return matrix_; }

private:
  RCP<const CrsMatrix> Z_;
  RCP<CrsMatrix> matrix_;
};
} // namespace asperity::tnnmg::detail
