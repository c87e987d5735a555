#include "platforms/TextFile.hpp"
#include "base/Errors.hpp"
#include "io/TextFormat.hpp"
#include "unit/platforms/Deck.hpp"

#include <limits>

using namespace asperity;
using namespace asperity::io;
using namespace asperity::platforms;

TEST(TextFile, WhatHasNoLogarithmHasTheSmallest)
{
  EXPECT_EQ(decimalLogarithm(100), 2);
  EXPECT_EQ(decimalLogarithm(0), -99);
  EXPECT_EQ(decimalLogarithm(1e-300), -99);
  EXPECT_EQ(decimalLogarithm(-1), -99);
}

TEST(TextFile, StepFactsCountAcceptedSteps)
{
  StepFacts facts;
  facts.add({0, 0, 0, 0, false}); // the initial state
  EXPECT_EQ(facts.count, 0);
  facts.add({1, 1, 1e-9, 0, false});
  facts.add({2, 2, 3e7, 0, false});
  EXPECT_EQ(facts.count, 2);
  EXPECT_EQ(facts.shortest, 1e-9);
  EXPECT_EQ(facts.longest, 3e7);
}

TEST(TextFile, LinesAboutTheStepsKeepTheirLength)
{
  EXPECT_EQ(stepSizeLine("minimum_time_step", 1e-9), "minimum_time_step=1.000000E-09");
  EXPECT_EQ(stepSizeLine("a", 1e-9).size(), stepSizeLine("a", 3e7).size());
  EXPECT_EQ(countLine(123456789012), "num_time_steps=123456789012");
  EXPECT_EQ(countLine(0).size(), countLine(123456789012).size());
}

TEST(RunFacts, ComeFromTheDeck)
{
  test::Stage stage(5); // segments of x = 0, 1/16, 1/4, 9/16, 1
  const auto context = stage.context("unused");
  const auto facts = [&](ParameterList list) {
    completeAndValidate(list, *RunFacts::declare("TPV").list(), "Test");
    return RunFacts::from(list, context);
  };
  ParameterList list;
  EXPECT_EQ(facts(list).problem, "TPV");
  EXPECT_EQ(facts(list).date.size(), 10u); // of today
  EXPECT_NEAR(facts(list).element_size, 1.0 / 16, 1e-15);
  list.set("Problem", "TPV101").set("Date", "2024/05/31").set("Element Size", 50.0);
  EXPECT_EQ(facts(list).problem, "TPV101");
  EXPECT_EQ(facts(list).date, "2024/05/31");
  EXPECT_EQ(facts(list).element_size, 50);
  list.set("Problem", "TPV101\n1 2 3");
  EXPECT_THROW(facts(list), InputError);
}
