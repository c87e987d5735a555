#include "FullSolve.hpp"

#include "tnnmg/SparseRateMatrix.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace asperity::tnnmg::test
{
TnnmgSettings tight()
{
  TnnmgSettings settings;
  settings.absolute_tolerance = 0;
  settings.relative_tolerance = 1e-13;
  return settings;
}

Teuchos::ParameterList multigridParameters()
{
  Teuchos::ParameterList list("Multigrid");
  list.sublist("MueLu").set("coarse: max size", 40); // two levels at least in a small model
  return list;
}

TnnmgResult solveFull(RateProblem const& problem, NodalProblem const& nodes,
                      TnnmgSettings const& settings, Eigen::VectorXd& v,
                      std::map<int, double> const& held,
                      std::shared_ptr<LinearCorrection> correction)
{
  auto const& model = problem.model;
  if (!correction) {
    correction = std::make_shared<MultigridCorrection>(model.problem(), multigridParameters());
  }
  Tnnmg tnnmg(
    std::make_shared<SparseRateMatrix>(model.Z, model.nodesWith(problem.heldOnRank(held))),
    correction, settings);
  tnnmg.begin(model.scatter(problem.b), model.scatter(v));
  const auto result = tnnmg.solve(nodes);
  v = model.gather(tnnmg.v());
  return result;
}

Eigen::VectorXd atRest(RateProblem const& problem)
{
  return Eigen::VectorXd::Zero(problem.model.global.rows());
}
} // namespace asperity::tnnmg::test
