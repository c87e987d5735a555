#pragma once

#include "multigrid/FloatConjugateGradients.hpp"
#include "tnnmg/correction/MultigridOperator.hpp"

#include <Teuchos_ParameterList.hpp>

namespace asperity::tnnmg::detail
{
// Throws if Belos does not know a parameter or expects another type; a solve would not report it.
void checkBelosParameters(Teuchos::ParameterList const& belos);

// Preconditioned conjugate gradients (Belos) for A c = r from c = 0 until |r - A c| <=
// relative_tolerance |r|. The true residual is computed at the end; if rounding has made it larger
// than the residual that the iteration updates, the iteration is continued. belos: Belos's own
// parameters, without tolerance and number of iterations.
multigrid::IterationResult conjugateGradients(RCP<const Operator> const& A,
                                              RCP<const Operator> const& preconditioner,
                                              Vector const& r, double relative_tolerance,
                                              int max_iterations,
                                              Teuchos::ParameterList const& belos, Vector& c);
} // namespace asperity::tnnmg::detail
