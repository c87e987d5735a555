// When the iteration of TNNMG ends, and when it counts as converged.
#include "FullSolve.hpp"
#include "tnnmg/SparseRateMatrix.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::tnnmg
{
using namespace tnnmg::test;

TEST(Tnnmg, SaysThatItHasNotConverged)
{
  const RateProblem problem({1., 2, 1, Kind::both});
  auto settings = tight();
  settings.max_iterations = 2;
  auto v = atRest(problem);
  const auto result = solveFull(problem, problem.nodesOfRank(), settings, v);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_GT(result.error, 1e-13 * problem.energyNorm(v));
}

TEST(Tnnmg, StopsAtTheToleranceThatIsReachedFirst)
{
  const RateProblem problem({1., 2, 1, Kind::both});
  const auto reference = problem.reference();
  auto coarse = tight();
  coarse.absolute_tolerance = 1e-2 * problem.energyNorm(reference);
  auto v = atRest(problem);
  const auto early = solveFull(problem, problem.nodesOfRank(), coarse, v);
  EXPECT_TRUE(early.converged);
  EXPECT_LE(early.error, coarse.absolute_tolerance);
  v = atRest(problem);
  const auto late = solveFull(problem, problem.nodesOfRank(), tight(), v);
  EXPECT_LT(early.iterations, late.iterations);
  EXPECT_LE(late.error, 1e-13 * problem.energyNorm(v));
}

// Of v itself, not of its last change, which is the error before the last iteration.
TEST(Tnnmg, StopsWhenTheErrorIsWithinTheTolerance)
{
  int sooner_than_by_changes = 0;
  for (Kind kind : {Kind::logarithm, Kind::both}) {
    const RateProblem problem({1., 2, 1, kind});
    const auto reference = problem.reference();
    TnnmgSettings settings;
    settings.relative_tolerance = 0;
    for (double correction_tolerance : {1e-2, 0.1, 0.4}) {
      settings.correction_tolerance = correction_tolerance;
      for (double share = 0.1; share > 1e-11; share /= 10) {
        settings.absolute_tolerance = share * problem.energyNorm(reference);
        auto v = atRest(problem);
        const auto result = solveFull(problem, problem.nodesOfRank(), settings, v);
        EXPECT_TRUE(result.converged);
        EXPECT_LE(problem.energyNorm(v - reference), settings.absolute_tolerance)
          << correction_tolerance << ", " << share << ", " << result.error;
        sooner_than_by_changes += result.last_change > settings.absolute_tolerance;
      }
    }
  }
  EXPECT_GT(sooner_than_by_changes, 0);
}

namespace
{
// Its last rank's first node cannot be solved.
class FailingNodes : public RoughNodes
{
public:
  FailingNodes(RoughNodes const& nodes, bool fails) : RoughNodes(nodes), fails_(fails) {}
  int minimise(IndexView const& nodes, ConstNodeView const& curvature, ConstBlockView const& r,
               BlockView const& v) const override
  {
    int failures = RoughNodes::minimise(nodes, curvature, r, v);
    const auto which = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), nodes);
    for (std::size_t i = 0; i < which.extent(0); ++i) {
      failures += fails_ && which(i) == 0 ? 1 : 0;
    }
    return failures;
  }

private:
  bool fails_;
};
} // namespace

TEST(Tnnmg, DoesNotConvergeWhereANodeFailsOnAnyRank)
{
  const RateProblem problem({1e-3, 2, 1, Kind::both});
  auto const comm = problem.model.map->getComm();
  const FailingNodes nodes(problem.nodesOfRank(), comm->getRank() == comm->getSize() - 1);
  auto v = atRest(problem);
  const auto result = solveFull(problem, nodes, tight(), v);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.failed_nodes, result.iterations);
}

namespace
{
// Breaks down before its first iteration.
class LostCorrection : public LinearCorrection
{
public:
  explicit LostCorrection(double value) : value_(value) {}
  CorrectionResult solve(NonlinearBlocks const&, Vector const&, double, Vector& c) override
  {
    c.putScalar(value_);
    return {};
  }

private:
  double value_;
};

// Claims to have converged, with a correction that points uphill.
class UphillCorrection : public LinearCorrection
{
public:
  UphillCorrection(std::shared_ptr<LinearCorrection> right, double factor)
      : right_(std::move(right))
      , factor_(factor)
  {
  }
  CorrectionResult solve(NonlinearBlocks const& blocks, Vector const& r, double tolerance,
                         Vector& c) override
  {
    const auto result = right_->solve(blocks, r, tolerance, c);
    c.scale(factor_);
    return result;
  }

private:
  std::shared_ptr<LinearCorrection> right_;
  double factor_;
};
} // namespace

TEST(Tnnmg, DoesNotConvergeWhereNoCorrectionIsADescent)
{
  const RateProblem problem({1., 2, 1, Kind::logarithm});
  const auto solve = [&](double factor) {
    const auto right =
      std::make_shared<MultigridCorrection>(problem.model.problem(), multigridParameters());
    auto v = atRest(problem);
    return solveFull(problem, problem.nodesOfRank(), TnnmgSettings(), v, {},
                     std::make_shared<UphillCorrection>(right, factor));
  };
  const auto uphill = solve(-1);
  EXPECT_FALSE(uphill.converged);
  EXPECT_EQ(uphill.failed_corrections, uphill.iterations);
  EXPECT_LE(uphill.last_change, 1e-8) << "which would pass for convergence";
  const auto downhill = solve(1);
  EXPECT_TRUE(downhill.converged);
  EXPECT_EQ(downhill.failed_corrections, 0);
}

// Gauss-Seidel on the fault comes to rest against a body that nothing has moved.
TEST(Tnnmg, DoesNotConvergeWithoutCorrections)
{
  const RateProblem problem({1., 2, 1, Kind::logarithm});
  for (double value : {0., std::nan("")}) {
    auto v = atRest(problem);
    const auto result = solveFull(problem, problem.nodesOfRank(), TnnmgSettings(), v, {},
                                  std::make_shared<LostCorrection>(value));
    EXPECT_FALSE(result.converged);
    EXPECT_EQ(result.iterations, TnnmgSettings().max_iterations);
    EXPECT_EQ(result.failed_corrections, result.iterations);
    EXPECT_LE(result.last_change, 1e-8) << "which would pass for convergence";
    EXPECT_TRUE(v.allFinite());
  }
}

namespace
{
// Says that it has not converged.
class UnfinishedCorrection : public LinearCorrection
{
public:
  explicit UnfinishedCorrection(std::shared_ptr<LinearCorrection> right) : right_(std::move(right))
  {
  }
  CorrectionResult solve(NonlinearBlocks const& blocks, Vector const& r, double tolerance,
                         Vector& c) override
  {
    auto result = right_->solve(blocks, r, tolerance, c);
    result.converged = false;
    return result;
  }

private:
  std::shared_ptr<LinearCorrection> right_;
};
} // namespace

// Changes may then be small although the error is not.
TEST(Tnnmg, EstimatesNothingFromCorrectionsThatHaveNotConverged)
{
  const RateProblem problem({1., 2, 1, Kind::logarithm});
  auto settings = tight();
  settings.max_iterations = 3;
  auto v = atRest(problem);
  const auto result =
    solveFull(problem, problem.nodesOfRank(), settings, v, {},
              std::make_shared<UnfinishedCorrection>(std::make_shared<MultigridCorrection>(
                problem.model.problem(), multigridParameters())));
  EXPECT_EQ(result.error, result.last_change);
}

// The first change says nothing about the error after it, however large changes were before.
TEST(Tnnmg, ForgetsTheChangesOfTheProblemBefore)
{
  const RateProblem problem({1., 2, 1, Kind::both});
  auto const& model = problem.model;
  auto settings = tight();
  settings.max_iterations = 3;
  Tnnmg tnnmg(std::make_shared<SparseRateMatrix>(model.Z, model.nodesWith(problem.heldOnRank({}))),
              std::make_shared<MultigridCorrection>(model.problem(), multigridParameters()),
              settings);
  tnnmg.begin(model.scatter(problem.b), model.scatter(atRest(problem)));
  const auto before = tnnmg.solve(problem.nodesOfRank());
  EXPECT_LT(before.error, before.last_change);
  tnnmg.begin(model.scatter(problem.b), Vector(tnnmg.v(), Teuchos::Copy));
  const auto result = tnnmg.improve(problem.nodesOfRank());
  EXPECT_LT(result.last_change, 0.5 * before.last_change);
  EXPECT_EQ(result.error, result.last_change);
}
} // namespace asperity::tnnmg
