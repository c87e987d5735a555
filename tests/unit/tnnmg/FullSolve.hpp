#pragma once

#include "RateProblem.hpp"

#include <Teuchos_ParameterList.hpp>

#include <map>
#include <memory>

namespace asperity::tnnmg::test
{
TnnmgSettings tight();
Teuchos::ParameterList multigridParameters();
Eigen::VectorXd atRest(RateProblem const& problem);

// TNNMG on all dofs of all ranks from v, where it leaves the result, with multigrid unless another
// correction is given.
TnnmgResult solveFull(RateProblem const& problem, NodalProblem const& nodes,
                      TnnmgSettings const& settings, Eigen::VectorXd& v,
                      std::map<int, double> const& held = {},
                      std::shared_ptr<LinearCorrection> correction = nullptr);

// The same on the fault alone, the rest condensed, with the direct correction; one rank.
TnnmgResult solveCondensed(RateProblem const& problem, NodalProblem const& nodes,
                           TnnmgSettings const& settings, Eigen::VectorXd& v,
                           std::map<int, double> const& held = {});
} // namespace asperity::tnnmg::test
