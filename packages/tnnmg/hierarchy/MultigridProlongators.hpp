#pragma once

#include "base/Types.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace asperity::tnnmg::detail
{
// A coarse level of a matrix: the prolongator to the level above, and the matrix P^T A P.
struct ProjectedLevel
{
  RCP<const CrsMatrix> P, A;
};

// The coarse levels of MueLu's aggregation for A, from fine to coarse; none if A is as small as the
// coarsest level may be. muelu: a complete list. A coarse level with fewer than rows_per_rank
// rows per rank on average moves to fewer ranks before it is aggregated further, since aggregates
// do not cross ranks; its prolongator's domain map has rows on those ranks alone. With
// rows_per_rank = 0 all levels stay. Throws as MueLuHierarchy. Collective.
std::vector<ProjectedLevel> coarseLevels(RCP<const CrsMatrix> const& A,
                                         RCP<const MultiVector> const& near_null_space,
                                         Teuchos::ParameterList const& muelu, int rows_per_rank);
} // namespace asperity::tnnmg::detail
