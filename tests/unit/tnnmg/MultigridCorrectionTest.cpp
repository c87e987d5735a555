#include "tnnmg/correction/MultigridCorrection.hpp"

#include "FaultState.hpp"
#include "portability/Renamed.hpp"

#include <Eigen/SparseCholesky>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace asperity::tnnmg
{
using namespace tnnmg::test;

namespace
{
constexpr double tolerance = 1e-8;
constexpr double small_step = 1e-3; // s
constexpr double large_step = 1;    // s

Teuchos::ParameterList parameters()
{
  Teuchos::ParameterList list("Linear Correction");
  list.sublist("MueLu").set("coarse: max size", 100); // several levels in a small model
  return list;
}

// The same, with the cycle of MueLu.
Teuchos::ParameterList parametersOfMueLu()
{
  auto list = parameters();
  list.set("Cycle", "MueLu");
  return list;
}

ElasticModel modelWith(double tau, int components = 2, int tangents = 1)
{
  ElasticModelOptions options;
  options.tau = tau;
  options.components = components;
  options.tangents = tangents;
  return ElasticModel(options);
}

// In large steps, where hierarchies follow the Hessians. Z couples a node's two tangents or not.
ElasticModel modelWithTangents(bool coupled)
{
  ElasticModelOptions options;
  options.tau = large_step;
  options.tangents = 2;
  options.components_are_coupled = coupled;
  return ElasticModel(options);
}

Eigen::VectorXd rightHandSide(ElasticModel const& model)
{
  return pseudorandomVector(static_cast<int>(model.global.rows()), 5);
}

struct Answer
{
  CorrectionResult result;
  Eigen::VectorXd correction;
};

Answer solve(MultigridCorrection& correction, ElasticModel const& model, FaultState const& state,
             Eigen::VectorXd const& right_hand_side, double relative_tolerance = tolerance)
{
  Vector c(model.map);
  c.putScalar(std::nan("")); // to be overwritten
  const Vector r = model.scatter(right_hand_side);
  const auto result = correction.solve(state.blocks(model), r, relative_tolerance, c);
  return {result, model.gather(c)};
}

Eigen::VectorXd solveDirectly(ElasticModel const& model, FaultState const& state,
                              Eigen::VectorXd const& right_hand_side)
{
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(state.matrix(model));
  return cholesky.solve(state.project(model, right_hand_side));
}

double energyNorm(Eigen::SparseMatrix<double> const& A, Eigen::VectorXd const& v)
{
  return std::sqrt(v.dot(A * v));
}

// Of the correction from the direct solve, relative to that.
double energyError(ElasticModel const& model, FaultState const& state,
                   Eigen::VectorXd const& right_hand_side, Eigen::VectorXd const& correction)
{
  const auto A = state.matrix(model);
  const auto exact = solveDirectly(model, state, right_hand_side);
  return energyNorm(A, correction - exact) / energyNorm(A, exact);
}

void checkSolution(ElasticModel const& model, FaultState const& state,
                   Eigen::VectorXd const& right_hand_side, Eigen::VectorXd const& correction)
{
  const auto r = state.project(model, right_hand_side);
  EXPECT_LE((r - state.matrix(model) * correction).norm(), 1.01 * tolerance * r.norm());
  EXPECT_LE(energyError(model, state, right_hand_side, correction), 1e-6);
  EXPECT_EQ((correction - state.project(model, correction)).norm(), 0)
    << "not zero where nothing may move";
}
} // namespace

struct Case
{
  double tau; // s
  int components;
  int tangents;
  int iterations; // counted, the most over truncations and 1 to 3 ranks
};

void PrintTo(Case const& c, std::ostream* out)
{
  *out << "tau " << c.tau << " s, " << c.components << " components, " << c.tangents << " tangents";
}

class MultigridCorrectionCase : public ::testing::TestWithParam<Case>
{
};

// Solves for Hessians of all sizes, each truncation in turn. The reference is the same on any
// number of ranks, so that the answers are.
void checkAllTruncations(MultigridCorrection& correction, ElasticModel const& model,
                         double most_iterations)
{
  const auto r = rightHandSide(model);
  for (auto truncation :
       {Truncation::none, Truncation::every_second, Truncation::left_half, Truncation::all}) {
    SCOPED_TRACE(static_cast<int>(truncation));
    const FaultState state(model, truncation);
    const auto answer = solve(correction, model, state, r);
    EXPECT_TRUE(answer.result.converged);
    EXPECT_LE(answer.result.iterations, most_iterations);
    EXPECT_LE(answer.result.v_cycles, answer.result.iterations + 1);
    checkSolution(model, state, r, answer.correction);
  }
}

TEST_P(MultigridCorrectionCase, MeetsDirectSolve)
{
  const auto model = modelWith(GetParam().tau, GetParam().components, GetParam().tangents);
  MultigridCorrection correction(model.problem(), parameters());
  checkAllTruncations(correction, model, 1.2 * GetParam().iterations);
}

// Symmetric Gauss-Seidel on each level, MueLu's default, is as good a smoother as ours, but a stiff
// node is cut off from coarse levels: half as many iterations again are allowed, and for this cycle
// nothing was chosen after a result.
TEST_P(MultigridCorrectionCase, MeetsDirectSolveByTheCycleOfMueLu)
{
  const auto model = modelWith(GetParam().tau, GetParam().components, GetParam().tangents);
  MultigridCorrection correction(model.problem(), parametersOfMueLu());
  checkAllTruncations(correction, model, 1.5 * GetParam().iterations);
}

// What a sweep costs is that of Gauss-Seidel, or twice that with Chebyshev; one of Jacobi smooths
// less. Twice as many iterations were allowed before the test first ran.
TEST_P(MultigridCorrectionCase, MeetsDirectSolveWithEverySmoother)
{
  const auto model = modelWith(GetParam().tau, GetParam().components, GetParam().tangents);
  for (std::string smoother : {"Chebyshev", "Block Jacobi"}) {
    SCOPED_TRACE(smoother);
    auto list = parameters();
    list.set("Smoother", smoother);
    MultigridCorrection correction(model.problem(), list);
    checkAllTruncations(correction, model, 2 * GetParam().iterations);
  }
}

// Theory bounds iterations by the contraction of a V-cycle, but gives no number for this one: the
// counts, and the fifth that the test allows beyond them, were chosen after the result.
INSTANTIATE_TEST_SUITE_P(Steps, MultigridCorrectionCase,
                         ::testing::Values(Case{1e-6, 2, 1, 8}, Case{1e-3, 2, 1, 6},
                                           Case{1e-1, 2, 1, 16}, Case{1, 2, 1, 17},
                                           Case{1e3, 2, 1, 17}, Case{1e-3, 2, 2, 6},
                                           Case{1, 2, 2, 20}, Case{1, 1, 1, 14}));

// Ifpack2's smoothers by their own list.
TEST(MultigridCorrection, SmoothersOfMueLusCycleAreChosen)
{
  const auto model = modelWith(large_step);
  const auto r = rightHandSide(model);
  const FaultState state(model, Truncation::every_second, -2, 2);
  auto chebyshev = parametersOfMueLu();
  chebyshev.sublist("MueLu").set("smoother: type", "CHEBYSHEV");
  chebyshev.sublist("MueLu").sublist("smoother: params").set("chebyshev: degree", 3);
  auto sweeps = parametersOfMueLu();
  sweeps.sublist("MueLu").set("smoother: type", "RELAXATION");
  sweeps.sublist("MueLu")
    .sublist("smoother: params")
    .set("relaxation: type", "Symmetric Gauss-Seidel")
    .set("relaxation: sweeps", 2);
  std::vector<int> iterations;
  for (auto const& list : {parametersOfMueLu(), sweeps, chebyshev}) {
    MultigridCorrection correction(model.problem(), list);
    const auto answer = solve(correction, model, state, r);
    EXPECT_TRUE(answer.result.converged);
    checkSolution(model, state, r, answer.correction);
    iterations.push_back(answer.result.iterations);
  }
  EXPECT_LT(iterations[1], iterations[0]);
  EXPECT_NE(iterations[2], iterations[0]);
}

TEST(MultigridCorrection, MildHessiansAreSolvedWithBothHierarchies)
{
  const auto model = modelWith(large_step);
  const auto r = rightHandSide(model);
  const FaultState state(model, Truncation::every_second, -2, 2);
  for (std::string hierarchy : {"Keep", "Rebuild"}) {
    SCOPED_TRACE(hierarchy);
    auto list = parameters();
    list.set("Hierarchy", hierarchy);
    MultigridCorrection correction(model.problem(), list);
    const auto answer = solve(correction, model, state, r);
    EXPECT_TRUE(answer.result.converged);
    checkSolution(model, state, r, answer.correction);
    EXPECT_EQ(correction.rebuilds(), hierarchy == "Rebuild" ? 1 : 0);
  }
}

TEST(MultigridCorrection, SmallStepsNeedNoHessiansOnCoarseLevels)
{
  const auto model = modelWith(small_step);
  auto list = parameters();
  list.set("Hierarchy", "Keep");
  MultigridCorrection correction(model.problem(), list);
  for (auto truncation : {Truncation::none, Truncation::left_half, Truncation::all}) {
    const FaultState state(model, truncation);
    // Cycles that contract by 0.06 (CyclesAloneContract) leave 1e-8 after 7, in the energy norm.
    // Hessians of all sizes keep this from bounding the residual: 10 was chosen after the result.
    EXPECT_LE(solve(correction, model, state, rightHandSide(model)).result.iterations, 10);
  }
  EXPECT_EQ(correction.rebuilds(), 0);
}

// On coarse levels a truncated node counts like one whose Hessian rivals Z.
TEST(MultigridCorrection, CoarseLevelsFollowWhenManyNodesChange)
{
  const auto model = modelWith(large_step);
  const auto r = rightHandSide(model);
  MultigridCorrection correction(model.problem(), parameters());
  FaultState state(model, Truncation::none, -9, -8);
  solve(correction, model, state, r);
  EXPECT_EQ(correction.rebuilds(), 0) << "these Hessians do not count";
  state.truncated.back() = 1;
  solve(correction, model, state, r);
  EXPECT_EQ(correction.rebuilds(), 0) << "for one node of 40";

  const FaultState truncated(model, Truncation::left_half, -9, -8);
  const auto followed = solve(correction, model, truncated, r);
  EXPECT_EQ(correction.rebuilds(), 1);
  solve(correction, model, truncated, r);
  EXPECT_EQ(correction.rebuilds(), 1);
  solve(correction, model, state, r);
  EXPECT_EQ(correction.rebuilds(), 2);

  auto kept_parameters = parameters();
  kept_parameters.set("Hierarchy", "Keep");
  MultigridCorrection kept(model.problem(), kept_parameters);
  EXPECT_LT(followed.result.iterations, solve(kept, model, truncated, r).result.iterations);
}

// Moderate Hessians count in smooth modes long before they rival the diagonal: without them the
// coarse levels correct by too much.
TEST(MultigridCorrection, CoarseLevelsFollowHessiansOfAnotherMagnitude)
{
  const auto model = modelWith(large_step);
  const auto r = rightHandSide(model);
  MultigridCorrection correction(model.problem(), parameters());
  int rebuilds = 0;
  for (double exponent : {-1.3, -1.0, -2.5}) { // of ten
    const FaultState state(model, Truncation::none, exponent, exponent);
    checkSolution(model, state, r, solve(correction, model, state, r).correction);
    rebuilds += exponent == -1.0 ? 0 : 1; // a factor of two is let pass
    EXPECT_EQ(correction.rebuilds(), rebuilds) << exponent;
  }
}

// On regular meshes Z does not couple the tangents of a node; friction does.
TEST(MultigridCorrection, WorksWhereZDoesNotCoupleTheTangents)
{
  const auto model = modelWithTangents(false);
  const auto r = rightHandSide(model);
  MultigridCorrection correction(model.problem(), parameters());
  for (auto truncation : {Truncation::left_half, Truncation::none, Truncation::every_second}) {
    const FaultState state(model, truncation, -2, 2);
    checkSolution(model, state, r, solve(correction, model, state, r).correction);
  }
  EXPECT_GT(correction.rebuilds(), 0);
  correction.reset();
  const FaultState state(model, Truncation::none, -2, 2);
  checkSolution(model, state, r, solve(correction, model, state, r).correction);
  MultigridCorrection by_muelu(model.problem(), parametersOfMueLu());
  checkSolution(model, state, r, solve(by_muelu, model, state, r).correction);
}

// Between these nodes a translation across the wall has no share in an aggregate, which MueLu
// refuses.
TEST(MultigridCorrection, TakesAPatchThatSlidesAlongAWall)
{
  ElasticModelOptions options;
  options.tau = large_step;
  for (int x = 10; x < 25; ++x) {
    options.sliding.push_back(x);
  }
  const ElasticModel model(options);
  const auto r = rightHandSide(model);
  MultigridCorrection correction(model.problem(), parameters());
  for (auto truncation : {Truncation::none, Truncation::left_half}) {
    const FaultState state(model, truncation);
    const auto answer = solve(correction, model, state, r);
    EXPECT_TRUE(answer.result.converged);
    checkSolution(model, state, r, answer.correction);
  }
}

// To the last bit, whether the next solve has coarse levels of its Hessians or of Z alone. On
// several threads MueLu's cycle is equal up to rounding: its transposes have another order each
// time. The share of the correction that it may differ by was chosen after the result.
TEST(MultigridCorrection, ResetForgetsEarlierSolves)
{
  for (bool coupled : {true, false}) {
    const auto model = modelWithTangents(coupled);
    const auto r = rightHandSide(model);
    for (bool of_hessians : {false, true}) {
      const FaultState state = of_hessians ? FaultState(model, Truncation::every_second, -2, 2)
                                           : FaultState(model, Truncation::none, -9, -8);
      for (bool by_muelu : {false, true}) {
        SCOPED_TRACE(::testing::Message() << coupled << ' ' << of_hessians << ' ' << by_muelu);
        const auto list = by_muelu ? parametersOfMueLu() : parameters();
        MultigridCorrection fresh(model.problem(), list);
        MultigridCorrection used(model.problem(), list);
        solve(used, model, FaultState(model, Truncation::left_half, -2, 2), r);
        EXPECT_EQ(used.rebuilds(), 1);
        used.reset();
        const Eigen::VectorXd expected = solve(fresh, model, state, r).correction;
        const Eigen::VectorXd found = solve(used, model, state, r).correction;
        const double share = by_muelu && ExecutionSpace().concurrency() > 1 ? 1e-10 : 0;
        EXPECT_LE((found - expected).norm(), share * expected.norm());
        EXPECT_EQ(fresh.rebuilds(), of_hessians ? 1 : 0);
        EXPECT_EQ(used.rebuilds(), of_hessians ? 2 : 1);
      }
    }
  }
}

// Each cycle minimises the energy along its direction: the error decreases in the energy norm, at a
// rate below 1 for any number of unknowns. Theory gives no number; these were chosen after the
// result, the most on 1 to 3 ranks.
TEST(MultigridCorrection, CyclesAloneContract)
{
  struct Expected
  {
    double tau;
    char const* hierarchy;
    double contraction;
  };
  constexpr int cycles = 4;
  for (auto [tau, hierarchy, contraction] :
       {Expected{small_step, "Keep", 0.06}, Expected{small_step, "Rebuild", 0.06},
        Expected{large_step, "Keep", 0.9}, Expected{large_step, "Rebuild", 0.6}}) {
    const auto model = modelWith(tau);
    const auto r = rightHandSide(model);
    const FaultState state(model, Truncation::every_second);
    auto list = parameters();
    list.set("Method", "V-Cycles").set("V-Cycles", cycles).set("Hierarchy", hierarchy);
    MultigridCorrection correction(model.problem(), list);
    const auto answer = solve(correction, model, state, r);
    EXPECT_EQ(answer.result.v_cycles, cycles);
    const double error = energyError(model, state, r, answer.correction);
    EXPECT_LT(std::pow(error, 1.0 / cycles), contraction) << tau << ' ' << hierarchy;
  }
}

TEST(MultigridCorrection, LooseToleranceTakesFewIterations)
{
  const auto model = modelWith(large_step);
  const auto r = rightHandSide(model);
  const FaultState state(model, Truncation::none);
  MultigridCorrection correction(model.problem(), parameters());
  const auto answer = solve(correction, model, state, r, 0.1);
  EXPECT_TRUE(answer.result.converged);
  EXPECT_LE(answer.result.iterations, 3); // chosen after the result
  EXPECT_LE((state.project(model, r) - state.matrix(model) * answer.correction).norm(),
            0.1 * state.project(model, r).norm());
}

TEST(MultigridCorrection, SaysWhenItDoesNotConverge)
{
  const auto model = modelWith(large_step);
  auto list = parameters();
  list.set("Maximum Iterations", 2);
  MultigridCorrection correction(model.problem(), list);
  const auto answer =
    solve(correction, model, FaultState(model, Truncation::none), rightHandSide(model));
  EXPECT_FALSE(answer.result.converged);
  EXPECT_EQ(answer.result.iterations, 2);
  EXPECT_TRUE(answer.correction.allFinite());
}

TEST(MultigridCorrection, NoForceNoCorrection)
{
  const auto model = modelWith(large_step);
  for (std::string method : {"CG", "V-Cycles"}) {
    auto list = parameters();
    list.set("Method", method);
    MultigridCorrection correction(model.problem(), list);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.global.rows());
    const auto answer = solve(correction, model, FaultState(model, Truncation::none), zero);
    EXPECT_TRUE(answer.result.converged);
    EXPECT_EQ(answer.result.v_cycles, 0);
    EXPECT_EQ(answer.correction.norm(), 0);
  }
}

TEST(MultigridCorrection, ABodyWithoutFaultIsALinearProblem)
{
  auto model = modelWith(large_step);
  model.nonlinear.clear();
  model.mine.clear();
  model.nodes.dofs = Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace>("dofs", 0, 1);
  model.nodes.colours.clear();
  const FaultState state(model, Truncation::none);
  MultigridCorrection correction(model.problem(), parameters());
  const auto answer = solve(correction, model, state, rightHandSide(model));
  EXPECT_TRUE(answer.result.converged);
  checkSolution(model, state, rightHandSide(model), answer.correction);
}

// Z = 3 A + 0.5 B from the terms A and B, of which the first makes the prolongators.
TEST(MultigridCorrection, SharesProlongatorsAndProjectedTerms)
{
  const auto stiff = modelWith(large_step), heavy = modelWith(small_step);
  auto sum = stiff;
  sum.global = 3 * stiff.global + 0.5 * heavy.global;
  const auto Z = rcp(new CrsMatrix(*stiff.Z, Teuchos::Copy));
  Z->resumeFill();
  for (int row = 0; row < static_cast<int>(numLocalRows(*Z)); ++row) {
    const auto id = Z->getRowMap()->getGlobalElement(row);
    for (Eigen::SparseMatrix<double>::InnerIterator entry(sum.global, static_cast<int>(id)); entry;
         ++entry) {
      const GlobalOrdinal column = entry.row();
      const double value = entry.value();
      Z->replaceGlobalValues(id, 1, &value, &column);
    }
  }
  Z->fillComplete();
  sum.Z = Z;
  const MultigridTerms terms({[&] { return stiff.Z; }, [&] { return heavy.Z; }}, stiff.problem(),
                             parameters());
  EXPECT_FALSE(terms.empty());
  MultigridCorrection shared(sum.problem(), parameters(), terms, {3, 0.5});
  MultigridCorrection own(sum.problem(), parameters());
  const auto r = rightHandSide(sum);
  for (auto truncation : {Truncation::none, Truncation::left_half}) {
    const FaultState state(sum, truncation);
    const auto answer = solve(shared, sum, state, r);
    checkSolution(sum, state, r, answer.correction);
    EXPECT_LE(answer.result.iterations, 2 + solve(own, sum, state, r).result.iterations);
  }
}
} // namespace asperity::tnnmg
