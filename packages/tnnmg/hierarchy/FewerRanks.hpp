#pragma once

#include "base/Types.hpp"

namespace asperity::tnnmg::detail
{
// The rows of a coarse level on fewer ranks, such that these have at least `rows_per_rank` rows
// each on average (one rank has all if there are fewer): groups of successive ranks give their rows
// to the first of them that has any. Global ids do not change. Null if the rows may
// stay where they are. rows: ids ascend with the ranks and are successive on each. Collective.
RCP<const Map> onFewerRanks(Map const& rows, int rows_per_rank);

// The same matrix with its columns, or with rows and columns, owned as in `owners`. Collective.
RCP<const CrsMatrix> withColumnsOn(RCP<const Map> const& owners, CrsMatrix const& P);
RCP<const CrsMatrix> movedTo(RCP<const Map> const& owners, RCP<const CrsMatrix> const& A);
RCP<const MultiVector> movedTo(RCP<const Map> const& owners, MultiVector const& x);
} // namespace asperity::tnnmg::detail
