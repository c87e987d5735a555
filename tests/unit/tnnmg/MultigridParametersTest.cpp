#include "ElasticModel.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"
#include "unit/base/Refusal.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace asperity::tnnmg
{
using namespace tnnmg::test;

namespace
{
Teuchos::ParameterList parameters()
{
  Teuchos::ParameterList list("Linear Correction");
  list.sublist("MueLu").set("coarse: max size", 100); // several levels in a small model
  return list;
}
} // namespace

TEST(MultigridParameters, RefusesParametersThatNobodyKnows)
{
  const ElasticModel model{ElasticModelOptions()};
  auto with_coarse_solver = parameters();
  with_coarse_solver.sublist("MueLu").set("coarse: type", "KLU2");
  auto with_smoother = parameters();
  with_smoother.sublist("MueLu").set("smoother: type", "CHEBYSHEV");
  EXPECT_THROW(MultigridCorrection(model.problem(), with_smoother), InputError);
  EXPECT_THROW(MultigridCorrection(model.problem(), with_coarse_solver), InputError);
  with_smoother.set("Cycle", "MueLu");
  MultigridCorrection(model.problem(), with_smoother); // accepted
  auto with_repartitioning = with_smoother;
  with_repartitioning.sublist("MueLu").set("repartition: enable", true);
  EXPECT_THROW(MultigridCorrection(model.problem(), with_repartitioning), InputError);
  auto with_unknown_smoother = parameters();
  with_unknown_smoother.set("Smoother", "Soap");
  asperity::test::expectRefusal<InputError>(
    [&] { MultigridCorrection(model.problem(), with_unknown_smoother); },
    {"Smoother", "Soap", "Chebyshev"});
  auto of_muelu = parameters();
  of_muelu.set("Cycle", "MueLu").set("Smoother", "Chebyshev");
  asperity::test::expectRefusal<InputError>(
    [&] { MultigridCorrection(model.problem(), of_muelu); },
    {"Smoother = Chebyshev has no effect", "smoother: type"});
  auto with_unknown_method = parameters();
  with_unknown_method.set("Method", "W-Cycles");
  EXPECT_THROW(MultigridCorrection(model.problem(), with_unknown_method), InputError);
}

namespace
{
// The message of the error of the input, or nothing where the list is accepted.
std::string refusal(std::string const& list,
                    std::function<void(Teuchos::ParameterList&)> const& change,
                    std::string const& cycle = "Asperity")
{
  auto given = parameters();
  given.set("Cycle", cycle);
  change(given.sublist(list));
  ::testing::internal::CaptureStdout();
  std::string message;
  try {
    MultigridCorrection::requireAccepted(given);
  } catch (InputError const& error) {
    message = error.what();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  return message;
}
} // namespace

TEST(MultigridParameters, RefusesListsThatMueLuOrBelosDoesNotTake)
{
  using List = Teuchos::ParameterList;
  const auto algorithm = [](List& list) { list.set("multigrid algorithm", "SANDPAPER"); };
  asperity::test::expectParts(refusal("MueLu", algorithm), {"SANDPAPER"});
  asperity::test::expectParts(refusal("MueLu", [](List& list) { list.set("max level", 3); }),
                              {"Did you mean \"max levels\""});
  asperity::test::expectParts(refusal("MueLu", [](List& list) { list.set("max levels", "three"); }),
                              {"max levels"});
  asperity::test::expectParts(refusal("Belos", [](List& list) { list.set("Tolerence", 1e-3); }),
                              {"Tolerence"});
  asperity::test::expectParts(
    refusal(
      "MueLu", [](List& list) { list.set("smoother: type", "SOAP"); }, "MueLu"),
    {"SOAP"});
}

TEST(MultigridParameters, TakesListsThatMueLuAndBelosTake)
{
  using List = Teuchos::ParameterList;
  EXPECT_EQ(refusal("MueLu", [](List& list) { list.set("verbosity", "extreme"); }), "");
  EXPECT_EQ(refusal("MueLu", [](List& list) { list.set("multigrid algorithm", "unsmoothed"); }),
            "");
  EXPECT_EQ(refusal("Belos", [](List& list) { list.set("Timer Label", "correction"); }), "");
}

// MueLu refuses an aggregate without any share in the only vector, whatever the list says.
TEST(MultigridParameters, FailureOfTheSetUpIsNoFaultOfTheList)
{
  const ElasticModel model{ElasticModelOptions()};
  auto problem = model.problem();
  problem.near_null_space = rcp(new MultiVector(problem.Z->getRowMap(), 3)); // zero
  asperity::test::expectRefusal<SolveError>([&] { MultigridCorrection(problem, parameters()); },
                                            {"MueLu cannot set up"});
}
} // namespace asperity::tnnmg
