#include "parameters/Deck.hpp"

#include "unit/base/Refusal.hpp"

namespace
{
using namespace asperity;
using namespace asperity::test;
using Teuchos::Array;

class Override : public ::testing::Test
{
protected:
  Override()
  {
    ParameterList muelu;
    muelu.set("max levels", 5);
    muelu.set("damping", 0.5);
    valid = Declare()
              .sublist("Friction",
                       Declare()
                         .field("a", 0.01, "-", Range::positive(), "A.")
                         .choice("Law", "Regularised", {"Regularised", "Truncated"}, "Law.")
                         .list(),
                       "Friction.")
              .sublist("Time Stepping",
                       Declare()
                         .real("Largest Step", 1.0, "s", Range::positive(), "Largest.")
                         .integer("Steps", 10, Range::atLeast(0), "Steps.")
                         .boolean("Adaptive", true, "Adaptive.")
                         .text("Title", "1", "Title.")
                         .realArray("Times", optional, "s", Range::atLeast(0), "Times.")
                         .textArray("Names", optional, "Names.")
                         .list(),
                       "Time.")
              .openSublist("Regions", Declare().text("<region>", required, "Condition.").list(),
                           "Regions.")
              .foreignSublist("MueLu", muelu, "Multigrid.")
              .list();
  }

  void set(std::string const& assignment) { applyOverride(list, *valid, assignment); }

  std::string refused(std::string const& assignment)
  {
    return refusal([&] { set(assignment); });
  }

  Teuchos::RCP<ParameterList> valid;
  ParameterList list{"Asperity"};
};

TEST_F(Override, TakesTheDeclaredType)
{
  set("Time Stepping/Largest Step=2");
  set("Time Stepping/Steps=20");
  set("Time Stepping/Adaptive=false");
  set("Time Stepping/Title=42");
  set("Time Stepping/Times={0, 1.5}");
  set("Time Stepping/Names=V, alpha");
  set("Friction/Law=Truncated");
  auto& time = list.sublist("Time Stepping");
  EXPECT_EQ(time.get<double>("Largest Step"), 2.0);
  EXPECT_EQ(time.get<int>("Steps"), 20);
  EXPECT_FALSE(time.get<bool>("Adaptive"));
  EXPECT_EQ(time.get<std::string>("Title"), "42");
  EXPECT_EQ(time.get<Array<double>>("Times"), array<double>({0, 1.5}));
  EXPECT_EQ(time.get<Array<std::string>>("Names"), array<std::string>({"V", "alpha"}));
  EXPECT_EQ(list.sublist("Friction").get<std::string>("Law"), "Truncated");
  completeAndValidate(list, *valid, "Asperity");
}

TEST_F(Override, RootNameAndBlanksAreOptional)
{
  set("Asperity/Friction/a=0.02");
  EXPECT_EQ(list.sublist("Friction").get<double>("a"), 0.02);
  set(" Asperity / Friction / a = 0.03 ");
  EXPECT_EQ(list.sublist("Friction").get<double>("a"), 0.03);
}

TEST_F(Override, FieldMayBecomeAnExpressionOrHaveRegions)
{
  list.sublist("Friction").set("a", 0.01);
  set("Friction/a=x == 1 ? 0.1 : 0.2");
  EXPECT_EQ(list.sublist("Friction").get<std::string>("a"), "x == 1 ? 0.1 : 0.2");
  set("Friction/a/upper=0.5");
  set("Friction/a/lower=y^2");
  EXPECT_EQ(list.sublist("Friction").sublist("a").get<double>("upper"), 0.5);
  EXPECT_EQ(list.sublist("Friction").sublist("a").get<std::string>("lower"), "y^2");
  set("Friction/a=3");
  EXPECT_EQ(list.sublist("Friction").get<double>("a"), 3.0);
}

TEST_F(Override, OpenAndForeignLists)
{
  set("Regions/mantle=1");
  EXPECT_EQ(list.sublist("Regions").get<std::string>("mantle"), "1");
  list.sublist("MueLu").set("damping", 0.5).set("name", std::string("x"));
  set("MueLu/damping=1");
  set("MueLu/name=7");
  set("MueLu/new=7");
  set("MueLu/smoother: params/relaxation: sweeps=2");
  EXPECT_EQ(list.sublist("MueLu").get<double>("damping"), 1.0);
  EXPECT_EQ(list.sublist("MueLu").get<std::string>("name"), "7");
  EXPECT_EQ(list.sublist("MueLu").get<int>("new"), 7);
  EXPECT_EQ(list.sublist("MueLu").sublist("smoother: params").get<int>("relaxation: sweeps"), 2);
  expectParts(refused("MueLu/damping=much"),
              {"Asperity / MueLu / damping = 'much'", "a real number"});
}

TEST_F(Override, UnknownPathsWithTheNearest)
{
  expectParts(refused("Time Steping/Steps=1"),
              {"Asperity / Time Steping is unknown", "'Time Stepping'"});
  expectParts(refused("Time Stepping/Step=1"),
              {"Asperity / Time Stepping / Step is unknown", "'Steps'"});
  EXPECT_EQ(list.numParams(), 1); // the list the path went through
}

TEST_F(Override, WrongValues)
{
  expectParts(refused("Time Stepping/Steps=1.5"),
              {"Asperity / Time Stepping / Steps = 1.5", "an integer"});
  expectParts(refused("Time Stepping/Adaptive=maybe"), {"Adaptive = 'maybe'", "true or false"});
  expectParts(refused("Time Stepping/Largest Step=-1"),
              {"Largest Step = -1 is outside (0, inf) s"});
  expectParts(refused("Friction/Law=Truncatd"),
              {"Friction / Law = 'Truncatd'", "Did you mean 'Truncated'?"});
  expectParts(refused("Friction/a=-1"), {"Asperity / Friction / a = -1 is outside (0, inf)"});
}

// They may be computed from names; who resolves these, or the check at last, refuses what is not.
TEST_F(Override, TextsForNumbersAreLeftToTheCheck)
{
  set("Time Stepping/Largest Step=soon");
  set("Time Stepping/Times={1, a}");
  EXPECT_EQ(list.sublist("Time Stepping").get<std::string>("Times"), "{1, a}");
  expectRefusal([&] { completeAndValidate(list, *valid, "Asperity"); },
                {"Largest Step = 'soon'", "a number in (0, inf) s"});
  set("Time Stepping/Largest Step=1");
  expectRefusal([&] { completeAndValidate(list, *valid, "Asperity"); },
                {"Times = '{1, a}'", "an array of numbers"});
}

TEST_F(Override, EntriesAndListsAreRemoved)
{
  set("Regions/one=x");
  set("Regions/two=y");
  set("Friction/a=2");
  removeEntry(list, "Regions/one");
  EXPECT_FALSE(list.sublist("Regions").isParameter("one"));
  EXPECT_TRUE(list.sublist("Regions").isParameter("two"));
  removeEntry(list, "Asperity/Regions");
  EXPECT_FALSE(list.isParameter("Regions"));
  expectRefusal([&] { removeEntry(list, "Regions"); }, {"--remove 'Regions'", "no entry"});
  expectRefusal(
    [&] { removeEntry(list, "Frition/a"); },
    {"--remove 'Frition/a'", "no list Asperity / Frition.", "Did you mean 'Friction'?"});
  expectRefusal([&] { removeEntry(list, "Friction/b/c"); }, {"no list Asperity / Friction / b"});
}

TEST_F(Override, MalformedAssignments)
{
  expectParts(refused("Friction/a"), {"Friction/a", "Path/To/Parameter=value"});
  expectParts(refused("=3"), {"Path/To/Parameter=value"});
  expectParts(refused("Friction=3"), {"Asperity / Friction is a list"});
  expectParts(refused("Time Stepping/Steps/x=3"), {"Asperity / Time Stepping / Steps is no list"});
}
} // namespace
