#pragma once

#include "tnnmg/detail/MultigridOperator.hpp"

#include <Teuchos_ParameterList.hpp>

namespace asperity::tnnmg::detail
{
struct IterationResult
{
  bool converged = false;
  int iterations = 0; // one application of the preconditioner each
};

// Preconditioned conjugate gradients (Belos) for A c = r from c = 0 until |r - A c| <=
// relative_tolerance |r|. That is measured afterwards with the true residual; where rounding has
// separated it from the updated one, they go on. belos: Belos's own parameters, apart from
// tolerance and number of iterations.
IterationResult conjugateGradients(RCP<const Operator> A, RCP<const Operator> preconditioner,
                                   Vector const& r, double relative_tolerance, int max_iterations,
                                   Teuchos::ParameterList const& belos, Vector& c);
} // namespace asperity::tnnmg::detail
