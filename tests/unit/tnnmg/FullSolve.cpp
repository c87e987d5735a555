#include "FullSolve.hpp"

#include "tnnmg/DenseRateMatrix.hpp"
#include "tnnmg/SparseRateMatrix.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"
#include "tnnmg/direct/DenseCorrection.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

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

TnnmgResult solveCondensed(RateProblem const& problem, NodalProblem const& nodes,
                           TnnmgSettings const& settings, Eigen::VectorXd& v,
                           std::map<int, double> const& held)
{
  auto const& model = problem.model;
  std::vector<int> rows, flags;
  for (auto const& dofs : model.nonlinear) {
    rows.insert(rows.end(), dofs.begin(), dofs.end());
  }
  for (auto const& of_node : problem.heldOnRank(held)) {
    flags.insert(flags.end(), of_node.begin(), of_node.end());
  }
  const SchurComplement schur(*model.Z, rows);
  const auto S =
    std::make_shared<DenseRateMatrix>(schur.matrix(), schur.map(), model.options.tangents, flags);
  Tnnmg tnnmg(S, std::make_shared<DenseCorrection>(S->entries(), S->nodes().dofs), settings);
  auto const b = schur.condense(model.scatter(problem.b));
  Vector guess(schur.map());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    guess.replaceLocalValue(static_cast<int>(i), v(rows[i]));
  }
  tnnmg.begin(b.kept(), guess);
  const auto result = tnnmg.solve(nodes);
  Vector all(model.map);
  b.expand(tnnmg.v(), all);
  v = model.gather(all);
  return result;
}

Eigen::VectorXd atRest(RateProblem const& problem)
{
  return Eigen::VectorXd::Zero(problem.model.global.rows());
}
} // namespace asperity::tnnmg::test
