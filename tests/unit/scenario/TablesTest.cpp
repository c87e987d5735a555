#include "scenario/deck/Tables.hpp"

#include "SampleDeck.hpp"
#include "base/Text.hpp"
#include "parameters/Deck.hpp"
#include "parameters/ParameterInfo.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/fields/Field.hpp"
#include "parameters/fields/TableFunction.hpp"
#include "scenario/DeckReader.hpp"
#include "scenario/Fingerprint.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/setup/rock/RockSetup.hpp"
#include "unit/base/TemporaryDirectory.hpp"

namespace asperity::scenario
{
using namespace test;
using asperity::test::TemporaryDirectory;

namespace
{
// A deck in a file, beside which other files may stand.
class TableDeck
{
public:
  TableDeck() : deck(shortDeck()) {}

  // A table in the deck.
  ParameterList& add(std::string const& name, std::vector<double> const& arguments,
                     std::vector<double> const& values)
  {
    auto& list = deck.sublist("Tables").sublist(name);
    return list.set("Arguments", array(arguments)).set("Values", array(values));
  }
  // A table in crust.csv.
  ParameterList& addFile(std::string const& content)
  {
    write(content);
    deck.sublist("Tables").remove("rho", false);
    auto& list = deck.sublist("Tables").sublist("rho");
    return list.set("From", "File")
      .set("File Name", "crust.csv")
      .set("Argument Column", "depth")
      .set("Value Column", "density");
  }
  void write(std::string const& content) const { directory_.write("crust.csv", content); }

  RCP<ParameterList> read() const
  {
    CommandLine line;
    line.deck = directory_.file("deck.xml");
    writeParameters(deck, line.deck);
    return readCompleteDeck(line);
  }
  Field density() const
  {
    return Field(read()->sublist("Bulk"), "Density", "Asperity / Bulk", {"left", "right"});
  }
  void setDensity(std::string const& text)
  {
    deck.sublist("Bulk").remove("Density");
    deck.sublist("Bulk").set("Density", text);
  }

  ParameterList deck;

private:
  TemporaryDirectory directory_;
};

// What is wrong with a deck with the table "rho", once it is changed.
template <class Change>
std::string refused(Change const& change)
{
  TableDeck given;
  change(given, given.add("rho", {0, 1}, {1, 2}));
  return refusal([&] { given.read(); });
}
} // namespace

TEST(Tables, AreFunctionsInFieldsNamesAndNumbers)
{
  TableDeck given;
  given.add("rho", {0, 2}, {1000, 3000});
  given.deck.sublist("Names").set("rock", "rho(-y) + rho(depth)").set("depth", 1.);
  given.setDensity("rock * 2");
  given.deck.sublist("Bulk").set("Gravitational Acceleration", "rho(depth) / 200");
  EXPECT_EQ(given.density()({0, -1.5, 0}, 0, 0), 9000);
  EXPECT_EQ(given.read()->sublist("Bulk").get<double>("Gravitational Acceleration"), 10);
  given.deck.sublist("Bulk").remove("Density");
  given.deck.sublist("Bulk").sublist("Density").set("left", "rho(x)").set("right", 7.);
  EXPECT_EQ(given.density()({0.5, 0, 0}, 0, 0), 1500);
  EXPECT_EQ(given.density()({0.5, 0, 0}, 0, 1), 7);
}

TEST(Tables, TakeNamesInTheirNumbers)
{
  TableDeck given;
  auto& table = given.add("rho", {}, {});
  table.remove("Arguments");
  table.set("Arguments", "{0, 2 * bottom}").set("Values", array<double>({1, 2}));
  table.set("Argument Unit", "km").set("Value Unit", "g/cm^3");
  table.set("Outside", "Value").set("Value Outside", "3 * bottom");
  given.deck.sublist("Names").set("bottom", 5.);
  given.setDensity("rho(x)");
  EXPECT_EQ(given.density()({5e3, 0, 0}, 0, 0), 1500);
  EXPECT_EQ(given.density()({-1, 0, 0}, 0, 0), 15);
}

// As a deck can say it in both ways.
TEST(Tables, WithStepsAreNestedQuestions)
{
  const std::vector<double> tops = {0, 0.1, 0.25, 0.3, 0.45, 0.7, 0.8, 1.1, 1.3, 1.7};
  std::vector<double> densities;
  std::string questions;
  for (std::size_t layer = 0; layer < tops.size(); ++layer) {
    densities.push_back(1000 + 37.3 * static_cast<double>(layer));
    if (layer + 1 < tops.size()) {
      questions += "2 - y < " + formatNumber(tops[layer + 1]) + " ? " +
                   formatNumber(densities.back()) + " : (";
    }
  }
  questions += formatNumber(densities.back()) + std::string(tops.size() - 1, ')');
  TableDeck by_table, by_questions;
  by_table.add("rho", tops, densities).set("Interpolation", "Step").set("Outside", "Nearest");
  by_table.setDensity("rho(2 - y)");
  by_questions.setDensity(questions);
  auto const field = by_table.density(), expected = by_questions.density();
  for (int i = 0; i <= 2000; ++i) {
    const std::array<double, 3> x = {0.3, 2 - 1e-3 * i, 0};
    EXPECT_EQ(field(x, 0, 0), expected(x, 0, 0)) << i;
  }
  const auto mesh = twoRegions();
  const auto densitiesOf = [&](TableDeck const& deck) {
    auto const list = deck.read()->sublist("Bulk");
    std::vector<double> result;
    for (auto const& material :
         makeRock(BulkSettings::from(list), list, mesh, *world()).materials) {
      result.push_back(material.density);
    }
    return result;
  };
  EXPECT_EQ(densitiesOf(by_table), densitiesOf(by_questions));
}

TEST(Tables, AreReadFromFilesBesideTheDeck)
{
  TableDeck given;
  given.addFile("depth [km], density [g/cm^3]\n0, 2\n10, 3\n");
  given.setDensity("rho(-y)");
  auto const complete = given.read();
  EXPECT_EQ(given.density()({0, -5e3, 0}, 0, 0), 2500);
  auto const& name = complete->sublist("Tables").sublist("rho").get<std::string>("File Name");
  EXPECT_EQ(name.front(), '/');
  expectRefusal(
    [&] {
      given.density()({0, -2e4, 0}, 0, 0);
    },
    {"Asperity / Bulk / Density = 'rho(-y)' has no value at (x, y, z) = (0, -20000, 0)",
     "Asperity / Tables / rho has arguments from 0 to 10000, but 20000 is wanted"});
}

TEST(Tables, HaveTheUnitOfTheFieldThatTheyAre)
{
  TableDeck given;
  given.addFile("depth [km], density [km/s]\n0, 2\n10, 3\n");
  given.deck.sublist("Names").set("rock", "rho(-y)");
  for (std::string const text : {"rho(-y)", " rho( 2 * (1 - y) )", "rock"}) {
    given.setDensity(text);
    expectRefusal([&] { given.density(); },
                  {"Asperity / Bulk / Density = '", "is in km/s, as Asperity / Tables / rho says",
                   "but kg/m^3 is wanted"});
  }
  for (std::string const text : {"rho(-y) * 1", "max(rho(-y), rho(1))", "(rho(-y)) / (rho(0))"}) {
    given.setDensity(text);
    EXPECT_GT(given.density()({0, -1, 0}, 0, 0), 0) << text;
  }
  given.setDensity("rho(-y)");
  given.write("depth [km], density [g/cm^3]\n0, 2\n10, 3\n");
  EXPECT_EQ(given.density()({0, 0, 0}, 0, 0), 2000);
  given.write("depth, density\n0, 2\n10, 3\n");
  EXPECT_EQ(given.density()({0, 0, 0}, 0, 0), 2);
}

TEST(Tables, AreRefusedWithWhatIsWrong)
{
  const auto with = [](char const* entry, char const* value) {
    return refused([&](TableDeck&, ParameterList& rho) { rho.set(entry, value); });
  };
  expectParts(with("File Name", "crust.csv"),
              {"Asperity / Tables / rho / File Name", "From = File"});
  expectParts(with("Outside", "Value"), {"Asperity / Tables / rho / Value Outside is missing"});
  expectParts(with("Argument Unit", "miles"),
              {"Asperity / Tables / rho / Argument Unit: the unit 'miles'"});
  expectParts(with("Interpolation", "Liner"),
              {"Asperity / Tables / rho / Interpolation", "Did you mean 'Linear'?"});
  expectParts(refused([](TableDeck& given, ParameterList&) {
                given.addFile("depth, density\n0, 1\n").remove("Value Column");
              }),
              {"Asperity / Tables / rho / Value Column is missing"});
  expectParts(refused([](TableDeck& given, ParameterList&) {
                given.add("rho", {1, 0}, {1, 2});
              }),
              {"Asperity / Tables / rho, row 2", "less than 1"});
  expectParts(refused([](TableDeck& given, ParameterList&) {
                given.add("sin", {0, 1}, {1, 2});
              }),
              {"Asperity / Tables / sin", "another name"});
  expectParts(
    refused([](TableDeck& given, ParameterList&) { given.deck.sublist("Names").set("rho", 3.); }),
    {"Asperity / Names / rho", "Tables has 'rho', too"});
  expectParts(refused([](TableDeck& given, ParameterList&) {
                given.deck.remove("Tables");
                given.deck.set("Tables", 3.);
              }),
              {"Asperity / Tables is not a list"});
  TableDeck given;
  given.add("rho", {0, 1}, {1, 2});
  given.setDensity("rhoo(x)");
  expectRefusal([&] { given.density(); }, {"rhoo", "its Tables 'rho'"});
}

TEST(Tables, GiveNothingToOtherDecks)
{
  TableDeck given;
  given.add("rho", {0, 1}, {1, 2});
  given.setDensity("rho(x)");
  EXPECT_EQ(given.density()({1, 0, 0}, 0, 0), 2);
  TableDeck other;
  other.setDensity("rho(x)");
  expectRefusal([&] { other.density(); }, {"Asperity / Bulk / Density = 'rho(x)' is no valid"});
}

TEST(Tables, ThatChangedAreNoticedByARestart)
{
  TableDeck given;
  given.addFile("depth [km], density [g/cm^3]\n0, 2\n10, 3\n");
  given.setDensity("rho(y)");
  const auto of = [&] { return fingerprint(*given.read(), Mesh<2>(), *world()); };
  auto const first = of();
  EXPECT_EQ(io::difference(first, of()), "");
  given.write("depth [km], density [g/cm^3]\n0, 2\n10, 3.1\n");
  expectParts(io::difference(first, of()), {"the content of table file '", "crust.csv'",
                                            "Asperity / Tables / rho / File Name", "has changed"});
}
} // namespace asperity::scenario
