#pragma once

#include "tnnmg/detail/MultigridOperator.hpp"

#include <Teuchos_ParameterList.hpp>

namespace asperity::tnnmg::detail
{
struct IterationResult
{
  bool converged = false;
  int iterations = 0; // each applies the preconditioner once
};

// Throws if Belos does not know a parameter or expects another type; a solve would not report it.
void checkBelosParameters(Teuchos::ParameterList const& belos);

// Preconditioned conjugate gradients (Belos) for A c = r from c = 0 until |r - A c| <=
// relative_tolerance |r|. After a tight tolerance (below 1e-3) the true residual is computed; if
// rounding has made it larger than the residual that the iteration updates, the iteration is
// continued. belos: Belos's own parameters, without tolerance and number of iterations.
IterationResult conjugateGradients(RCP<const Operator> A, RCP<const Operator> preconditioner,
                                   Vector const& r, double relative_tolerance, int max_iterations,
                                   Teuchos::ParameterList const& belos, Vector& c);
} // namespace asperity::tnnmg::detail
