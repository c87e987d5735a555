#include "FuzzTarget.hpp"
#include "Scratch.hpp"

#include "parameters/XmlDeck.hpp"
#include "parameters/fields/Field.hpp"
#include "scenario/deck/DeckAssembly.hpp"
#include "scenario/deck/Names.hpp"

#include <deque>
#include <sstream>
#include <stdexcept>

// The input is the text of a deck. A line that begins with %overlay ends it and begins an overlay;
// the rest of a line that begins with %set or %remove is the text behind that option.
namespace asperity::fuzz
{
namespace
{
struct Texts
{
  std::vector<std::string> decks; // the deck and its overlays
  std::vector<std::string> overrides, removals;
};

Texts textsOf(std::string const& input)
{
  Texts texts{{""}, {}, {}};
  std::istringstream lines(input);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("%overlay", 0) == 0) {
      texts.decks.emplace_back();
    } else if (line.rfind("%set ", 0) == 0) {
      texts.overrides.push_back(line.substr(5));
    } else if (line.rfind("%remove ", 0) == 0) {
      texts.removals.push_back(line.substr(8));
    } else {
      texts.decks.back() += line + '\n';
    }
  }
  return texts;
}

RCP<const ParameterList> plugin(std::string const& unit)
{
  return Declare()
    .real("Length", 0.5, unit, Range::positive(), "A length.")
    .choice("Word", "one", {"one", "two"}, "A word.")
    .list();
}

RCP<ParameterList> foreign()
{
  auto list = rcp(new ParameterList);
  list->set("max levels", 10);
  list->sublist("smoother").set("type", "RELAXATION");
  return list;
}

// All kinds of declarations: those of the program need all its packages, solvers and outputs.
RCP<const ParameterList> declarations()
{
  static const RCP<const ParameterList> list =
    Declare()
      .openSublist(scenario::names_list, scenario::nameParameters(), scenario::meaningOfNames())
      .real("Real", 1.5, "m", Range::positive(), "A number.")
      .hint("Take a positive one.")
      .integer("Integer", 3, Range::closed(1, 10), "An integer.")
      .boolean("Boolean", false, "True or false.")
      .text("Text", "some", "A text.")
      .fileName("File Name", "", "A file.")
      .field("Field", 2., "Pa", Range::any(), "A field.")
      .field("Positive Field", "1 + x^2", "Pa", Range::positive(), "A field.")
      .field("Optional Field", optional, "Pa", Range::any(), "A field.")
      .realArray("Reals", std::vector<double>{1, 2}, "m", Range::any(), "Numbers.")
      .integerArray("Integers", optional, Range::atLeast(0), "Integers.")
      .textArray("Texts", optional, "Texts.")
      .choiceOfLists("Type", "First", {{"First", plugin("m")}, {"Second", plugin("s")}}, "A type.")
      .choice("Law", "Mine", {"Mine", "Yours"}, "A law.")
      .entriesWith("Law", "Mine", Declare().real("a", 0.01, "-", Range::any(), "a").list())
      .entriesWith("Law", "Yours", Declare().real("b", 0.01, "-", Range::any(), "b").list())
      .sublist("List", plugin("kg"), "A list.")
      .openSublist("Open",
                   Declare().field("<name>", required, "-", Range::any(), "A condition.").list(),
                   "Conditions.")
      .foreignSublist("Foreign", *foreign(), "Of another library.")
      .list();
  return list;
}

void evaluate(ParameterList const& deck, std::string const& name)
{
  if (!deck.isParameter(name)) {
    return;
  }
  const Field field(deck, name, "Asperity", {"upper", "lower"});
  for (const double x : {0., 0.75, -3e5}) {
    for (int region = 0; region < 2 && !field.isDataset(); ++region) {
      field({x, -x, 1}, 10, region);
    }
  }
}

RCP<ParameterList> assembled(CommandLine const& line)
{
  auto const given = scenario::deckAsGiven(line, *declarations());
  scenario::assembleDeck(given, *declarations());
  return given.list;
}

// parameters.xml of a run, from which a restart reads its deck.
void requireReadable(ParameterList const& deck, Scratch const& file)
{
  std::ostringstream text;
  writeXml(deck, "Asperity", text, 0);
  file.write(text.str());
  CommandLine line;
  line.deck = file.path();
  assembled(line);
}
} // namespace

void tryInput(std::string const& input)
{
  const auto texts = textsOf(input);
  CommandLine line;
  std::deque<Scratch> files;
  for (auto const& text : texts.decks) {
    files.emplace_back("deck_" + std::to_string(files.size()) + ".xml").write(text);
    line.overlays.push_back(files.back().path());
  }
  line.deck = line.overlays.front();
  line.overlays.erase(line.overlays.begin());
  line.overrides = texts.overrides;
  line.removals = texts.removals;
  const auto deck = assembled(line);
  const Scratch copy("parameters.xml");
  try {
    requireReadable(*deck, copy);
  } catch (InputError const& error) {
    throw std::logic_error(std::string("parameters.xml cannot be read: ") + error.what());
  }
  for (char const* name : {"Field", "Positive Field", "Optional Field"}) {
    evaluate(*deck, name);
  }
}
} // namespace asperity::fuzz
