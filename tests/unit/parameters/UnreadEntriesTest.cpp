#include "parameters/UnreadEntries.hpp"

#include "unit/base/Refusal.hpp"

namespace
{
using namespace asperity;
using namespace asperity::test;

Teuchos::RCP<const ParameterList> steps()
{
  auto const tolerance = Declare().real("Tolerance", 1e-3, "-", Range::positive(), "One.").list();
  auto const control =
    Declare()
      .choiceOfLists("Control", "Fast", {{"Fast", tolerance}, {"Slow", tolerance}}, "How.")
      .list();
  auto const nested =
    Declare().sublist("Inner", tolerance, "A list.").real("Rate", 1., "-", Range::any(), "A rate.");
  return Declare()
    .sublist("Steps", control, "Steps.")
    .choiceOfLists("Kind", required, {{"Nested", nested.list()}, {"Plain", control}}, "A kind.")
    .list();
}

std::string textOf(ParameterList const& list)
{
  std::string text;
  for (auto const& entry : unreadEntries(list, *steps())) {
    text += entry.path + " (" + entry.choice + " = " + entry.taken + ", not " + entry.word + ")\n";
  }
  return text;
}

ParameterList given(std::string const& kind)
{
  ParameterList list;
  list.set("Kind", kind);
  return list;
}

TEST(UnreadEntries, AreThoseOfListsThatAreNotChosen)
{
  auto list = given("Plain");
  list.sublist("Steps").sublist("Slow").set("Tolerance", 1e-4);
  list.sublist("Steps").sublist("Fast").set("Tolerance", 1e-4);
  const std::string slow =
    "Steps / Slow / Tolerance (Steps / Control = Fast, not Slow)\n"; // Fast is the default
  EXPECT_EQ(textOf(list), slow);
  completeAndValidate(list, *steps(), "");
  EXPECT_EQ(textOf(list), slow);
  list.sublist("Steps").set("Control", std::string("Slow"));
  EXPECT_EQ(textOf(list), "Steps / Fast / Tolerance (Steps / Control = Slow, not Fast)\n");
}

TEST(UnreadEntries, AreFoundInListsOfLists)
{
  auto list = given("Plain");
  list.sublist("Nested").set("Rate", 2.).sublist("Inner").set("Tolerance", 1.);
  list.sublist("Plain").sublist("Slow").set("Tolerance", 1.);
  EXPECT_EQ(textOf(list), "Nested / Rate (Kind = Plain, not Nested)\n"
                          "Nested / Inner / Tolerance (Kind = Plain, not Nested)\n"
                          "Plain / Slow / Tolerance (Plain / Control = Fast, not Slow)\n");
}

TEST(UnreadEntries, NoneWhereAListIsEmptyOrChosen)
{
  auto list = given("Nested");
  list.sublist("Steps").sublist("Slow");
  list.sublist("Nested").set("Rate", 2.);
  EXPECT_EQ(textOf(list), "");
  list.set("Kind", std::string("Other"));
  expectRefusal([&] { textOf(list); }, {"Kind = 'Other'"});
}
} // namespace
