#include "FaultState.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <Eigen/SparseCholesky>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

namespace asperity::tnnmg
{
using namespace tnnmg::test;

namespace
{
constexpr double tolerance = 1e-8;

// MueLu's factories for threads and devices are those of "use kokkos refactor", which is off unless
// asked for.
Teuchos::ParameterList parametersOf(bool parallel_factories)
{
  Teuchos::ParameterList list("Linear Correction");
  auto& muelu = list.sublist("MueLu");
  muelu.set("use kokkos refactor", parallel_factories);
  muelu.set("coarse: max size", 100); // several levels in a small model
  return list;
}

// Solves with random right sides for all truncations in turn, compares each with a direct solve,
// and returns the sum of the iterations.
int iterations(ElasticModel const& model, bool parallel_factories)
{
  MultigridCorrection correction(model.problem(), parametersOf(parallel_factories));
  int sum = 0;
  for (auto truncation :
       {Truncation::none, Truncation::every_second, Truncation::left_half, Truncation::all}) {
    const FaultState state(model, truncation);
    const auto r = pseudorandomVector(static_cast<int>(model.global.rows()), 5);
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(state.matrix(model));
    const Eigen::VectorXd exact = cholesky.solve(state.project(model, r));
    Vector c(model.map);
    const auto result = correction.solve(state.blocks(model), model.scatter(r), tolerance, c);
    EXPECT_TRUE(result.converged);
    EXPECT_LE((model.gather(c) - exact).norm(), 1e-5 * exact.norm());
    sum += result.iterations;
  }
  return sum;
}

class OtherBackends : public ::testing::TestWithParam<double>
{
};

TEST_P(OtherBackends, NeedAboutAsManyIterations)
{
  ElasticModelOptions options;
  options.tau = GetParam();
  const ElasticModel model(options);
  const int serial = iterations(model, false);
  const int parallel = iterations(model, true);
  EXPECT_GT(serial, 0);
  EXPECT_LE(parallel, 1.2 * serial) << serial << " on one thread";
}

INSTANTIATE_TEST_SUITE_P(Steps, OtherBackends, ::testing::Values(1e-6, 1e-3, 1.)); // s
} // namespace
} // namespace asperity::tnnmg
