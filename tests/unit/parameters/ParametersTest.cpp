#include "parameters/Parameters.hpp"
#include "parameters/ParameterInfo.hpp"
#include "parameters/RangeText.hpp"

#include "unit/base/Refusal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace asperity;
using namespace asperity::test;
using Teuchos::Array;

Teuchos::RCP<ParameterList> frictionParameters()
{
  return Declare()
    .field("a", 0.015, "-", Range::positive(), "Direct effect.")
    .hint("Check the sign; typical values are 0.005 to 0.03.")
    .field("Density", required, "kg/m^3", Range::positive(), "Mass density.")
    .choice("Law", "Regularised", {"Regularised", "Truncated"}, "Law of friction.")
    .list();
}

Teuchos::RCP<ParameterList> rootParameters()
{
  return Declare()
    .real("Largest Step", 1.0, "s", Range::above(0), "Largest time step.")
    .real("Relative Tolerance", 1e-6, "-", Range::open(0, 1), "Tolerance.")
    .integer("Iterations", 100, Range::atLeast(1), "At most so many.")
    .boolean("Verbose", false, "Says more.")
    .text("Title", "untitled", "For the figures.")
    .fileName("Mesh File", optional, "Where the mesh is.")
    .realArray("Receivers", std::vector<double>{0.5}, "m", Range::atLeast(0), "Distances.")
    .integerArray("Levels", optional, Range::closed(0, 3), "Levels.")
    .textArray("Names", std::vector<std::string>{"V"}, "Fields.")
    .list();
}

// What the message must hold when one value is set in rootParameters().
template <class T>
std::string refusedRoot(std::string const& name, T const& value)
{
  ParameterList list;
  list.set(name, value);
  return refusal([&] { completeAndValidate(list, *rootParameters(), "Asperity / Time Stepping"); });
}

TEST(Parameters, DefaultsAreFilledInAndOptionalOnesLeftOut)
{
  ParameterList list;
  completeAndValidate(list, *rootParameters(), "Asperity");
  EXPECT_EQ(list.get<double>("Largest Step"), 1.0);
  EXPECT_EQ(list.get<int>("Iterations"), 100);
  EXPECT_FALSE(list.get<bool>("Verbose"));
  EXPECT_EQ(list.get<std::string>("Title"), "untitled");
  EXPECT_EQ(list.get<Array<double>>("Receivers"), array<double>({0.5}));
  EXPECT_EQ(list.get<Array<std::string>>("Names"), array<std::string>({"V"}));
  EXPECT_FALSE(list.isParameter("Mesh File"));
  EXPECT_FALSE(list.isParameter("Levels"));
}

TEST(Parameters, ValuesOfTheDeckStay)
{
  ParameterList list;
  list.set("Largest Step", 0.25);
  list.set("Mesh File", std::string("wedge.h5"));
  list.set("Levels", array<int>({0, 3}));
  completeAndValidate(list, *rootParameters(), "Asperity");
  EXPECT_EQ(list.get<double>("Largest Step"), 0.25);
  EXPECT_EQ(list.get<std::string>("Mesh File"), "wedge.h5");
  EXPECT_EQ(list.get<Array<int>>("Levels"), array<int>({0, 3}));
}

TEST(Parameters, CompletingTwiceChangesNothing)
{
  ParameterList list;
  list.set("Largest Step", 2);
  completeAndValidate(list, *rootParameters(), "Asperity");
  const ParameterList once = list;
  completeAndValidate(list, *rootParameters(), "Asperity");
  EXPECT_TRUE(once == list);
}

TEST(Parameters, IntegersBecomeNumbers)
{
  ParameterList list;
  list.set("Largest Step", 3);
  list.set("Receivers", array<int>({1, 2}));
  completeAndValidate(list, *rootParameters(), "Asperity");
  EXPECT_EQ(list.get<double>("Largest Step"), 3.0);
  EXPECT_EQ(list.get<Array<double>>("Receivers"), array<double>({1.0, 2.0}));
}

TEST(Parameters, UnknownNameWithTheNearest)
{
  expectParts(
    refusedRoot("Largets Step", 1.0),
    {"Asperity / Time Stepping / Largets Step is unknown.", "Did you mean 'Largest Step'?"});
}

TEST(Parameters, UnknownNameNearNothingListsAll)
{
  expectParts(refusedRoot("Quark Colour", 1.0),
              {"Asperity / Time Stepping / Quark Colour is unknown.", "Valid names are",
               "'Largest Step'", "'Names'"});
}

TEST(Parameters, WrongTypes)
{
  expectParts(refusedRoot("Iterations", 2.5), {"Asperity / Time Stepping / Iterations = 2.5",
                                               "a real number", "an integer in [1, inf)"});
  expectParts(refusedRoot("Iterations", 2.0), {"Iterations = 2", "a real number", "an integer"});
  expectParts(refusedRoot("Iterations", true), {"Iterations = true", "a boolean"});
  expectParts(refusedRoot("Largest Step", std::string("0.1")),
              {"Largest Step = '0.1'", "a text", "a number in (0, inf) s"});
  expectParts(refusedRoot("Verbose", std::string("yes")), {"Verbose = 'yes'", "true or false"});
  expectParts(refusedRoot("Verbose", 1), {"Verbose = 1", "an integer", "true or false"});
  expectParts(refusedRoot("Title", 5), {"Title = 5", "a text is wanted"});
  expectParts(refusedRoot("Mesh File", 5), {"Mesh File = 5", "the name of a file"});
  expectParts(refusedRoot("Receivers", 5.0),
              {"Receivers = 5", "an array of numbers in [0, inf) m"});
  expectParts(refusedRoot("Levels", array<double>({0.5})),
              {"Levels = {0.5}", "an array of integers"});
  expectParts(refusedRoot("Names", array<int>({1})), {"Names = {1}", "an array of texts"});
}

TEST(Parameters, ListWhereAValueIsWantedAndViceVersa)
{
  ParameterList list;
  list.sublist("Largest Step");
  expectRefusal([&] { completeAndValidate(list, *rootParameters(), "Asperity"); },
                {"Asperity / Largest Step", "a list", "a number"});
  const auto valid = Declare().sublist("Friction", frictionParameters(), "Friction.").list();
  ParameterList number;
  number.set("Friction", 0.6);
  expectRefusal([&] { completeAndValidate(number, *valid, "Asperity"); },
                {"Asperity / Friction = 0.6", "a list is wanted"});
}

TEST(Parameters, ValuesOutOfRange)
{
  expectParts(refusedRoot("Largest Step", 0.0),
              {"Asperity / Time Stepping / Largest Step = 0 is outside (0, inf) s."});
  expectParts(refusedRoot("Largest Step", -1), {"Largest Step = -1 is outside (0, inf) s."});
  expectParts(refusedRoot("Relative Tolerance", 1.0),
              {"Relative Tolerance = 1 is outside (0, 1)."});
  expectParts(refusedRoot("Iterations", 0), {"Iterations = 0 is outside [1, inf)."});
  expectParts(refusedRoot("Receivers", array<double>({1.0, -2.0})),
              {"Receivers[1] = -2 is outside [0, inf) m."});
  expectParts(refusedRoot("Levels", array<int>({0, 4})), {"Levels[1] = 4 is outside [0, 3]."});
}

TEST(Parameters, NanAndInfinityAreOutsideEveryRange)
{
  expectParts(refusedRoot("Largest Step", std::nan("")), {"Largest Step = ", "nan", "is outside"});
  expectParts(refusedRoot("Largest Step", std::numeric_limits<double>::infinity()),
              {"Largest Step = inf is outside"});
  EXPECT_FALSE(Range::any().contains(std::nan("")));
  EXPECT_FALSE(Range::any().contains(-std::numeric_limits<double>::infinity()));
}

TEST(Parameters, RangesHaveTexts)
{
  EXPECT_EQ(textOf(Range::closedOpen(-1, 0.5)), "[-1, 0.5)");
  EXPECT_EQ(textOf(Range::any()), "(-inf, inf)");
}

TEST(Parameters, MissingRequired)
{
  ParameterList list;
  expectRefusal([&] { completeAndValidate(list, *frictionParameters(), "Asperity / Bulk"); },
                {"Asperity / Bulk / Density is missing", "(0, inf) kg/m^3", "Mass density."});
}

TEST(Parameters, MisspelledRequiredIsCalledUnknownAndNotMissing)
{
  ParameterList list;
  list.set("Densty", 2700.0);
  expectRefusal([&] { completeAndValidate(list, *frictionParameters(), "Asperity / Bulk"); },
                {"Densty is unknown", "'Density'"});
}

TEST(Parameters, AllErrorsAreToldAtOnce)
{
  ParameterList list;
  list.set("Titel", "wedge");
  list.set("Largest Step", -1.0);
  list.sublist("Friction").set("a", -0.01);
  list.sublist("Mesh").set("Widht", 3.0);
  auto const valid = Declare()
                       .real("Largest Step", 1.0, "s", Range::above(0), "Largest time step.")
                       .text("Title", "untitled", "For the figures.")
                       .sublist("Friction", frictionParameters(), "Friction.")
                       .list();
  const auto message = refusal([&] { completeAndValidate(list, *valid, "Asperity"); });
  expectParts(message,
              {"Asperity / Titel is unknown", "\nAsperity / Largest Step = -1",
               "\nAsperity / Friction / a = -0.01", "\nAsperity / Friction / Density is missing",
               "Asperity / Mesh is unknown"});
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 4);
}

TEST(Parameters, OfManyErrorsTenAreTold)
{
  ParameterList list;
  for (char letter = 'a'; letter < 'n'; ++letter) {
    list.set(std::string(20, letter), 1);
  }
  const auto message = refusal([&] { completeAndValidate(list, *rootParameters(), "Asperity"); });
  expectParts(message, {"\nThere are 3 more errors."});
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 10);
}

TEST(Parameters, HintJoinsTheMessage)
{
  ParameterList list;
  list.set("Density", 2700.0);
  list.set("a", -0.01);
  EXPECT_EQ(
    refusal([&] { completeAndValidate(list, *frictionParameters(), "Friction"); }),
    "Friction / a = -0.01 is outside (0, inf). Check the sign; typical values are 0.005 to 0.03.");
}

TEST(Parameters, ChoiceOfWords)
{
  ParameterList list;
  list.set("Density", 1000.0);
  list.set("Law", std::string("Regularized"));
  expectRefusal([&] { completeAndValidate(list, *frictionParameters(), "Friction"); },
                {"Friction / Law = 'Regularized'", "'Regularised' or 'Truncated'",
                 "Did you mean 'Regularised'?"});
}

TEST(Parameters, FieldTakesNumberExpressionAndRegions)
{
  ParameterList list;
  list.set("a", std::string("0.01 + x"));
  list.sublist("Density").set("upper", 2700).set("lower", std::string("3300 + y"));
  completeAndValidate(list, *frictionParameters(), "Friction");
  EXPECT_EQ(list.get<std::string>("a"), "0.01 + x");
  EXPECT_EQ(list.sublist("Density").get<double>("upper"), 2700.0);
}

TEST(Parameters, FieldRefusals)
{
  const auto refused = [](auto const& fill) {
    ParameterList list;
    list.set("Density", 1000.0);
    fill(list);
    return refusal([&] { completeAndValidate(list, *frictionParameters(), "Friction"); });
  };
  expectParts(refused([](auto& list) { list.set("a", true); }),
              {"Friction / a = true", "an expression"});
  expectParts(refused([](auto& list) { list.sublist("a").set("upper", -1.0); }),
              {"Friction / a / upper = -1 is outside (0, inf)."});
  expectParts(refused([](auto& list) { list.sublist("a").set("upper", true); }),
              {"Friction / a / upper = true"});
  expectParts(refused([](auto& list) { list.sublist("a").sublist("upper"); }),
              {"Friction / a / upper", "a list", "a number or an expression"});
}

TEST(Parameters, FieldsOffVerticesDoNotOfferDatasets)
{
  const auto refused = [](Declare declare) {
    ParameterList list;
    list.set("Velocity", true);
    return refusal([&] { completeAndValidate(list, *declare.list(), "Drive"); });
  };
  Declare declare;
  declare.field("Velocity", optional, "m/s", Range::any(), "Of the drive.");
  expectParts(refused(declare), {"file.h5:/dataset"});
  declare.withoutDatasets();
  EXPECT_EQ(refused(declare).find("dataset"), std::string::npos);
}

TEST(Parameters, FieldDefaultMayBeAnExpression)
{
  ParameterList list;
  completeAndValidate(
    list, *Declare().field("L", "1e-5 * (1 + x)", "m", Range::positive(), "Distance.").list(), "");
  EXPECT_EQ(list.get<std::string>("L"), "1e-5 * (1 + x)");
}

TEST(Parameters, SettingACompletedEntryIsCheckedToo)
{
  ParameterList list("Asperity");
  completeAndValidate(list, *rootParameters(), "Asperity");
  expectRefusal([&] { list.set("Largest Step", -2.0); },
                {"Asperity / Largest Step = -2 is outside (0, inf) s."});
}

TEST(Parameters, DeclaringADefaultOutOfRangeIsAMistake)
{
  expectRefusal([] { Declare().real("a", -1.0, "-", Range::positive(), "A."); },
                {"The default of a = -1", "(0, inf)"});
  EXPECT_THROW(Declare().boolean("a", true, "A.").boolean("a", true, "A."), std::logic_error);
}

TEST(Parameters, DeclarationsGoToTheListOfTheCaller)
{
  ParameterList list("own");
  Declare(list).real("a", 1, "m", Range::any(), "A.");
  EXPECT_EQ(list.get<double>("a"), 1.0);
  EXPECT_EQ(parameterInfo(list, "a")->unit, "m");
  EXPECT_TRUE(parameterInfo(list, "b").is_null());
}
} // namespace
