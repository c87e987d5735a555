#include "scenario/deck/Names.hpp"

#include "SampleDeck.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/fields/Expression.hpp"

#include <cmath>

namespace asperity::scenario
{
using namespace test;

namespace
{
RCP<const ParameterList> valid()
{
  return Declare()
    .openSublist(names_list, nameParameters(), meaningOfNames())
    .sublist("Bulk",
             Declare()
               .field("Density", required, "kg/m^3", Range::positive(), "Density.")
               .realArray("Direction", std::vector<double>{0., -1.}, "-", Range::any(), "Down.")
               .real("Height", 1., "m", Range::positive(), "Height.")
               .text("Title", "", "Title.")
               .list(),
             "Bulk.")
    .openSublist("Regions", Declare().field("<region>", required, "-", Range::any(), "C.").list(),
                 "Regions.")
    .list();
}

ParameterList deckWith(std::vector<std::pair<std::string, std::string>> const& names)
{
  ParameterList deck;
  for (auto const& [name, text] : names) {
    deck.sublist(names_list).set(name, text);
  }
  deck.sublist("Bulk").set("Density", 1000.);
  return deck;
}

double valueOf(ParameterList const& list, std::string const& name, double x)
{
  return Expression(list.get<std::string>(name), name)({x, 0, 0}, 0);
}

std::string refused(std::vector<std::pair<std::string, std::string>> const& names,
                    std::vector<std::string> const& to_be_used = {})
{
  auto deck = deckWith(names);
  deck.sublist("Bulk").set("Height", "slope");
  return refusal([&] { resolveNames(deck, *valid(), to_be_used); });
}
} // namespace

TEST(Names, StandForTheirValuesWhereverNumbersAreWanted)
{
  auto deck = deckWith({{"slope", "0.27"}, {"zone", "x < slope^2"}, {"rock", "2 * slope - 1e-1"}});
  auto& bulk = deck.sublist("Bulk");
  bulk.set("Direction", "{slope, -max(slope, 1)}");
  bulk.set("Height", "-3 * -slope");
  bulk.set("Title", "slope");
  bulk.remove("Density");
  bulk.sublist("Density").set("upper", "zone ? rock : e");
  bulk.sublist("Density").set("lower", 7.);
  deck.sublist("Regions").set("left", "zone");
  resolveNames(deck, *valid());
  completeAndValidate(deck, *valid(), "Asperity");
  EXPECT_EQ(bulk.get<Teuchos::Array<double>>("Direction"), array<double>({0.27, -1.}));
  EXPECT_DOUBLE_EQ(bulk.get<double>("Height"), 0.81);
  EXPECT_EQ(bulk.get<std::string>("Title"), "slope");
  EXPECT_DOUBLE_EQ(valueOf(bulk.sublist("Density"), "upper", 0.07), 0.44);
  EXPECT_DOUBLE_EQ(valueOf(bulk.sublist("Density"), "upper", 0.08), std::exp(1.));
  EXPECT_EQ(valueOf(deck.sublist("Regions"), "left", 0.07), 1);
  EXPECT_TRUE(namesIn(deck.sublist(names_list)).empty());
}

TEST(Names, AreWholeWordsAndNoFunctions)
{
  auto deck = deckWith({{"s", "3"}, {"e5", "0"}, {"max_", "2"}});
  deck.sublist("Bulk").set("Density", "ss_1 + 1e5 + 2E5 + sin(s) + max_ + abs (s)");
  EXPECT_EQ(
    refusal([&] {
      resolveNames(deck, *valid());
      valueOf(deck.sublist("Bulk"), "Density", 0);
    }).substr(0, 60),
    std::string("Density = 'ss_1 + 1e5 + 2E5 + sin((3)) + (2) + abs ((3))' is").substr(0, 60));
}

TEST(Names, ArithmeticNeedsNone)
{
  auto deck = deckWith({});
  deck.sublist("Bulk").set("Height", "3 * 3600");
  resolveNames(deck, *valid());
  EXPECT_EQ(deck.sublist("Bulk").get<double>("Height"), 10800);
}

TEST(Names, ThatGrowWithoutEndAreRefused)
{
  std::vector<std::pair<std::string, std::string>> doubling, chain;
  for (int i = 0; i < 40; ++i) {
    const auto next = "n" + std::to_string(i + 1);
    doubling.emplace_back("n" + std::to_string(i), next + " + " + next);
  }
  doubling.emplace_back("n40", "1");
  expectParts(refused(doubling), {"Names / n", "more than 20000 characters"});
  for (int i = 0; i < 2000; ++i) {
    chain.emplace_back("n" + std::to_string(i), "n" + std::to_string(i + 1));
  }
  chain.emplace_back("n2000", "1");
  expectParts(refused(chain), {"Names / n", "more than 100 names"});
}

TEST(Names, AreRefusedWithWhatIsWrong)
{
  expectParts(refused({{"slope", "2 * other"}, {"other", "slope"}}), {"Names / ", "loop"});
  expectParts(refused({{"exp", "1"}}), {"Names / exp", "meaning", "another name"});
  expectParts(refused({{"t", "1"}}), {"Names / t", "another name"});
  expectParts(refused({{"zone end", "1"}}), {"Names / zone end", "letters, digits and _"});
  expectParts(refused({{"slope", "2 +"}}), {"Names / slope", "no valid expression"});
  expectParts(refused({{"slope", "mesh.h5:/slope"}}),
              {"Names / slope", "a number or an expression"});
  expectParts(refused({{"slope", "0.2"}, {"slpoe", "0.3"}}, {"slpoe"}),
              {"Names / slpoe is used nowhere", "Did you mean 'slope'?"});
}

TEST(Names, LeaveToTheCheckOfTypesWhatIsNoNumber)
{
  auto deck = deckWith({{"zone", "x < 1"}});
  deck.sublist("Bulk").set("Height", "20 min");
  resolveNames(deck, *valid());
  expectRefusal([&] { completeAndValidate(deck, *valid(), "Asperity"); },
                {"Height = '20 min' is a text, but a number"});
  deck = deckWith({{"zone", "x < 1"}});
  deck.sublist("Bulk").set("Height", "zone"); // depends on x
  resolveNames(deck, *valid());
  expectRefusal([&] { completeAndValidate(deck, *valid(), "Asperity"); },
                {"Height = 'zone' is a text, but a number"});
}
} // namespace asperity::scenario
