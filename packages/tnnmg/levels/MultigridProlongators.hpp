#pragma once

#include "base/Types.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace asperity::tnnmg::detail
{
// The prolongators of MueLu's hierarchy for A, from the finest level to the coarsest; none if A is
// as small as the coarsest level may be. The parameters are MueLu's. Throws SolveError if MueLu
// fails; std::bad_alloc is passed on.
std::vector<RCP<const CrsMatrix>> prolongators(RCP<const CrsMatrix> const& A,
                                               MultiVector const& near_null_space,
                                               Teuchos::ParameterList const& muelu);
} // namespace asperity::tnnmg::detail
