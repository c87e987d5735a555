#include "parameters/Deck.hpp"

#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <sstream>

namespace
{
using namespace asperity;
using namespace asperity::test;
using List = Teuchos::RCP<const ParameterList>;

List rate(Range range, double value = 1e-6, std::string const& unit = "m/s")
{
  return Declare().field("Rate", value, unit, range, "Slip rate of reference.").list();
}

// Two choices whose words bring entries: "Rate" comes from both.
List pair(List const& of_law, List const& of_state)
{
  const auto other =
    Declare().real("Width", 3., "m", Range::positive(), "Width of the asperity.").list();
  return Declare()
    .choice("Law", "First", {"First", "Other"}, "The law.")
    .choice("State", "Only", {"Only"}, "The state law.")
    .entriesWith("Law", "First", of_law)
    .entriesWith("Law", "Other", other)
    .entriesWith("State", "Only", of_state)
    .real("Cohesion", 0., "Pa", Range::atLeast(0), "Cohesion of the fault.")
    .list();
}

List usual() { return pair(rate(Range::positive()), rate(Range::positive())); }

TEST(Alternatives, TheChosenWordBringsItsEntries)
{
  ParameterList list;
  completeAndValidate(list, *usual(), "Asperity / Friction");
  EXPECT_EQ(list.numParams(), 4); // Law, State, Rate once, Cohesion
  EXPECT_EQ(list.get<double>("Rate"), 1e-6);

  ParameterList other;
  other.set("Law", std::string("Other")).set("Width", 4);
  completeAndValidate(other, *usual(), "Asperity / Friction");
  EXPECT_EQ(other.get<double>("Width"), 4);
  EXPECT_EQ(other.get<double>("Rate"), 1e-6); // the state law's
}

TEST(Alternatives, AnEntryOfAnotherWordIsRefusedWithThatWord)
{
  ParameterList list;
  list.set("Width", 4.);
  expectRefusal([&] { completeAndValidate(list, *usual(), "Friction"); },
                {"Friction / Width is unknown here", "parameter of Law = Other"});
  ParameterList misspelled;
  misspelled.set("Law", std::string("Other")).set("Widht", 4.);
  expectRefusal([&] { completeAndValidate(misspelled, *usual(), "Friction"); },
                {"Friction / Widht is unknown. Did you mean 'Width'?"});
  ParameterList unknown;
  unknown.set("Law", std::string("Othre"));
  expectRefusal([&] { completeAndValidate(unknown, *usual(), "Friction"); },
                {"Friction / Law = 'Othre'", "Did you mean 'Other'?"});
}

TEST(Alternatives, WhatTwoBringIsInBothRanges)
{
  const auto valid = pair(rate(Range::closed(1e-9, 1e-3)), rate(Range::open(1e-7, 1)));
  const auto refused = [&](double value) {
    ParameterList list;
    list.set("Rate", value);
    return refusal([&] { completeAndValidate(list, *valid, "Friction"); });
  };
  expectParts(refused(1e-8), {"Friction / Rate = 1e-08", "(1e-07, 0.001] m/s"});
  expectParts(refused(0.1), {"Friction / Rate = 0.1", "(1e-07, 0.001] m/s"});
  ParameterList list;
  list.set("Rate", 1e-3);
  completeAndValidate(list, *valid, "Friction");
}

TEST(Alternatives, TwoThatContradictEachOtherAreAMistake)
{
  const auto refused = [](List const& of_state) {
    ParameterList list;
    EXPECT_THROW(
      completeAndValidate(list, *pair(rate(Range::positive()), of_state), "Asperity / Friction"),
      std::logic_error);
  };
  refused(rate(Range::below(0), -1));             // no number in both
  refused(rate(Range::above(1e-6), 1));           // another default
  refused(rate(Range::positive(), 1e-6, "km/s")); // another unit
  refused(Declare().field("Rate", required, "m/s", Range::positive(), "Slip rate.").list());
  refused(Declare().integer("Rate", 1, Range::positive(), "Slip rate.").list());
  refused(Declare().real("Cohesion", 1., "Pa", Range::atLeast(0), "Cohesion.").list());
}

TEST(Alternatives, AnOverrideSeesTheWordChosenBefore)
{
  const auto valid = Declare().sublist("Friction", usual(), "Friction.").list();
  ParameterList list;
  expectRefusal([&] { applyOverride(list, *valid, "Friction/Width=2"); },
                {"Asperity / Friction / Width is unknown here", "parameter of Law = Other"});
  applyOverride(list, *valid, "Friction/Law=Other");
  applyOverride(list, *valid, "Friction/Width=2");
  EXPECT_EQ(list.sublist("Friction").get<double>("Width"), 2);
}

TEST(Alternatives, AllArePrinted)
{
  const auto valid = Declare().sublist("Friction", usual(), "Friction.").list();
  std::ostringstream text, xml;
  printParameters(*valid, text, ParameterFormat::text);
  expectParts(text.str(), {"Asperity / Friction\n", "Asperity / Friction, with Law = First\n",
                           "Asperity / Friction, with Law = Other\n  Width\n",
                           "Asperity / Friction, with State = Only\n  Rate\n"});
  printParameters(*valid, xml, ParameterFormat::xml);
  expectParts(xml.str(), {"<!--\nFriction, with Law = Other\n  Width\n"});
  const TemporaryDirectory directory;
  const auto deck = readDeck(directory.write("deck.xml", xml.str()));
  completeAndValidate(*deck, *valid, "Asperity");
  EXPECT_EQ(deck->sublist("Friction").get<double>("Rate"), 1e-6);
  EXPECT_FALSE(deck->sublist("Friction").isParameter("Width"));
}
} // namespace
