#include "tnnmg/direct/DenseCorrection.hpp"

#include "FaultState.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::tnnmg
{
using namespace tnnmg::test;

namespace
{
constexpr double tolerance = 1e-9;

// Small enough to be dense as a whole; nothing in it is held by constraints of its own.
ElasticModel modelWith(int tangents)
{
  ElasticModelOptions options;
  options.cells_x = 9;
  options.cells_y = 3;
  options.tau = 1;
  options.tangents = tangents;
  return ElasticModel(options);
}

// The residual, where nothing may be read not a number.
Vector residual(ElasticModel const& model, FaultState const& state)
{
  auto r = pseudorandomVector(static_cast<int>(model.global.rows()), 5);
  for (std::size_t node = 0; node < state.truncated.size(); ++node) {
    for (int row : model.nonlinear[node]) {
      r(row) = state.truncated[node] ? std::nan("") : r(row);
    }
  }
  return model.scatter(r);
}

struct Answer
{
  CorrectionResult result;
  double error = 0; // of the residual, relative
};

Answer solve(DenseCorrection& correction, ElasticModel const& model, FaultState const& state,
             double to = tolerance)
{
  Vector c(model.map);
  c.putScalar(std::nan("")); // to be overwritten
  Answer answer;
  answer.result = correction.solve(state.blocks(model), residual(model, state), to, c);
  const auto solution = model.gather(c);
  const int size = static_cast<int>(model.global.rows());
  auto r = pseudorandomVector(size, 5);
  for (std::size_t node = 0; node < state.truncated.size(); ++node) {
    for (int row : model.nonlinear[node]) {
      if (state.truncated[node]) {
        EXPECT_EQ(solution(row), 0);
        r(row) = 0;
      }
    }
  }
  answer.error = (r - state.matrix(model) * solution).norm() / r.norm();
  return answer;
}
} // namespace

TEST(DenseCorrection, SolvesWithHessiansAndTruncation)
{
  for (int tangents : {1, 2}) {
    const auto model = modelWith(tangents);
    for (auto truncation :
         {Truncation::none, Truncation::every_second, Truncation::left_half, Truncation::all}) {
      DenseCorrection correction(denseCopyOf(*model.Z), model.nodes.dofs);
      const auto answer = solve(correction, model, FaultState(model, truncation, -2, 6));
      EXPECT_TRUE(answer.result.converged);
      EXPECT_LE(answer.error, 1e-10) << "Hessians of all sizes ask for a factor";
    }
  }
}

// Tolerances that single precision meets.
TEST(DenseCorrection, SolvesLooselyInSinglePrecision)
{
  for (int tangents : {1, 2}) {
    const auto model = modelWith(tangents);
    for (auto truncation :
         {Truncation::none, Truncation::every_second, Truncation::left_half, Truncation::all}) {
      DenseCorrection correction(denseCopyOf(*model.Z), model.nodes.dofs);
      for (const double loose : {1e-2, 1e-3}) {
        const auto answer = solve(correction, model, FaultState(model, truncation, -2, 6), loose);
        EXPECT_TRUE(answer.result.converged);
        EXPECT_LE(answer.error, 1.01 * loose);
        EXPECT_GT(answer.error, 1e-12) << "no double has been here";
      }
    }
  }
}

// Units must not matter: the squares of these leave the range of single precision.
TEST(DenseCorrection, SolvesWhateverTheUnits)
{
  for (const double unit : {1e-30, 1e30}) {
    const auto model = modelWith(1);
    const auto scaled = rcp(new CrsMatrix(*model.Z, Teuchos::Copy));
    scaled->resumeFill();
    scaled->scale(unit);
    scaled->fillComplete();
    FaultState state(model, Truncation::every_second, -2, 6);
    const Vector r = residual(model, state);
    Vector expected(model.map), c(model.map), tiny_r(model.map);
    DenseCorrection correction(denseCopyOf(*model.Z), model.nodes.dofs);
    ASSERT_TRUE(correction.solve(state.blocks(model), r, 1e-2, expected).converged);
    for (auto& value : state.hessian) {
      value *= unit;
    }
    tiny_r.update(1e-25, r, 0);
    DenseCorrection in_units(denseCopyOf(*scaled), model.nodes.dofs);
    ASSERT_TRUE(in_units.solve(state.blocks(model), tiny_r, 1e-2, c).converged);
    c.update(-1, expected, unit / 1e-25);
    EXPECT_LE(c.norm2(), 1e-3 * expected.norm2()) << unit;
  }
}

// Two dofs that differ only by a tenth of the precision of floats: their difference is free there.
TEST(DenseCorrection, TurnsToDoubleWhereSinglePrecisionDoesNotSuffice)
{
  auto model = modelWith(1);
  const auto nearly_singular = rcp(new CrsMatrix(*model.Z, Teuchos::Copy));
  nearly_singular->resumeFill();
  nearly_singular->setAllToScalar(0);
  const int size = static_cast<int>(model.global.rows());
  for (int row = 0; row < size; ++row) {
    const double one = 1;
    ASSERT_EQ(nearly_singular->replaceLocalValues(row, 1, &one, &row), 1);
  }
  const int first = model.nonlinear[0][0];
  int second = -1;
  auto const local = model.Z->getLocalMatrixHost();
  for (auto k = local.graph.row_map(first); k < local.graph.row_map(first + 1); ++k) {
    second = local.graph.entries(k) != first ? local.graph.entries(k) : second;
  }
  ASSERT_GE(second, 0);
  const double nearly_one = 1 - 6e-9;
  nearly_singular->replaceLocalValues(first, 1, &nearly_one, &second);
  nearly_singular->replaceLocalValues(second, 1, &nearly_one, &first);
  nearly_singular->fillComplete();

  FaultState state(model, Truncation::none, -2, 2);
  for (auto& value : state.hessian) {
    value.setZero();
  }
  Vector r(model.map), c(model.map);
  r.putScalar(0);
  r.replaceLocalValue(first, 1);
  r.replaceLocalValue(second, -1);
  DenseCorrection correction(denseCopyOf(*nearly_singular), model.nodes.dofs);
  ASSERT_TRUE(correction.solve(state.blocks(model), r, 1e-2, c).converged);
  EXPECT_NEAR(c.getData()[first] * 6e-9, 1, 2e-2);
  EXPECT_NEAR(c.getData()[second] * 6e-9, -1, 2e-2);
}

// The condition number with the diagonal is at most 1.003, so that an iteration reduces the error
// a thousandfold.
TEST(DenseCorrection, NeedsNoFactorWhereTheDiagonalRules)
{
  auto model = modelWith(1);
  const auto strong = rcp(new CrsMatrix(*model.Z, Teuchos::Copy));
  Vector diagonal(model.map);
  model.Z->getLocalDiagCopy(diagonal);
  strong->resumeFill();
  for (int row = 0; row < static_cast<int>(diagonal.getLocalLength()); ++row) {
    const double value = 1000 * diagonal.getData()[row];
    strong->sumIntoLocalValues(row, 1, &value, &row);
  }
  strong->fillComplete();
  const FaultState state(model, Truncation::every_second, -2, 6);
  Vector c(model.map);
  DenseCorrection correction(denseCopyOf(*strong), model.nodes.dofs);
  const auto result = correction.solve(state.blocks(model), residual(model, state), tolerance, c);
  EXPECT_TRUE(result.converged);
  EXPECT_GE(result.iterations, 1);
  EXPECT_LE(result.iterations, 4);
  EXPECT_GT(c.norm2(), 0);
}

// Hessians that follow: close ones by conjugate gradients with the old factor, all to tolerance.
TEST(DenseCorrection, KeepsItsFactorWhereThatSuffices)
{
  const auto model = modelWith(1);
  DenseCorrection correction(denseCopyOf(*model.Z), model.nodes.dofs);
  FaultState state(model, Truncation::every_second, -1, 1);
  solve(correction, model, state);

  state.hessian[2] *= 1.01;
  const auto close = solve(correction, model, state);
  EXPECT_TRUE(close.result.converged);
  EXPECT_GE(close.result.iterations, 1);
  EXPECT_LE(close.result.iterations, 3) << "one eigenvalue differs from 1";
  EXPECT_LE(close.error, 1.01 * tolerance);

  for (auto truncation : {Truncation::none, Truncation::left_half, Truncation::all}) {
    const auto far = solve(correction, model, FaultState(model, truncation, -2, 6));
    EXPECT_TRUE(far.result.converged);
    EXPECT_LE(far.error, 1.01 * tolerance);
  }
}

TEST(DenseCorrection, ForgetsItsFactor)
{
  const auto model = modelWith(2);
  DenseCorrection used(denseCopyOf(*model.Z), model.nodes.dofs);
  DenseCorrection fresh(denseCopyOf(*model.Z), model.nodes.dofs);
  const FaultState first(model, Truncation::none, -2, 3);
  const FaultState second(model, Truncation::left_half, -1, 2);
  solve(used, model, first);
  used.reset();
  Vector c_used(model.map);
  Vector c_fresh(model.map);
  const Vector r = residual(model, second);
  const auto result = used.solve(second.blocks(model), r, tolerance, c_used);
  const auto expected = fresh.solve(second.blocks(model), r, tolerance, c_fresh);
  EXPECT_EQ(result.iterations, expected.iterations);
  c_used.update(-1, c_fresh, 1);
  EXPECT_EQ(c_used.normInf(), 0) << "the answer depends on what was solved before";
}

TEST(DenseCorrection, SaysThatAMatrixIsNotDefinite)
{
  const auto model = modelWith(1);
  CrsMatrix broken(*model.Z, Teuchos::Copy);
  broken.resumeFill();
  const double value = -1e6;
  const int row = 30;
  broken.replaceLocalValues(row, 1, &value, &row);
  broken.fillComplete();
  DenseCorrection correction(denseCopyOf(broken), model.nodes.dofs);
  const FaultState state(model, Truncation::none, -2, 2);
  Vector c(model.map);
  const auto result = correction.solve(state.blocks(model), residual(model, state), tolerance, c);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(c.normInf(), 0) << "no step rather than a wrong one";
}
} // namespace asperity::tnnmg
