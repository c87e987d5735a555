#include "parameters/Deck.hpp"

#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace
{
using namespace asperity;
using namespace asperity::test;
using Teuchos::Array;

// A deck with this between its root's tags, read.
Teuchos::RCP<ParameterList> readContent(std::string const& content)
{
  const TemporaryDirectory directory;
  return readDeck(directory.write("deck.xml", "<ParameterList name=\"Asperity\">\n" + content +
                                                "</ParameterList>\n"));
}

std::string refusedText(std::string const& text)
{
  const TemporaryDirectory directory;
  const auto file = directory.write("deck.xml", text);
  return refusal([&] { readDeck(file); });
}

std::string refusedContent(std::string const& content)
{
  return refusal([&] { readContent(content); });
}

TEST(Deck, ReadsEveryType)
{
  const auto list = readContent(R"xml(
    <!-- all of them -->
    <Parameter name="i" type="int" value="-3"/>
    <Parameter name="d" type="double" value=" 1e-3 "/>
    <Parameter name="b" type="bool" value="true"/>
    <Parameter name="s" type="string" value="x &lt; 0.3 &amp;&amp; y &gt; 1 ? 1 : 2"/>
    <Parameter name="ad" type="Array(double)" value="{1, 2.5}"/>
    <Parameter name="ai" type="Array(int)" value="{}"/>
    <Parameter name="as" type="Array(string)" value="{one, two}"/>
    <Parameter name="ll" type="long long" value="12345678901"/>
    <ParameterList name="Sub"><Parameter name="a" type="int" value="1"/></ParameterList>)xml");
  EXPECT_EQ(list->get<int>("i"), -3);
  EXPECT_EQ(list->get<double>("d"), 1e-3);
  EXPECT_TRUE(list->get<bool>("b"));
  EXPECT_EQ(list->get<std::string>("s"), "x < 0.3 && y > 1 ? 1 : 2");
  EXPECT_EQ(list->get<Array<double>>("ad"), array<double>({1, 2.5}));
  EXPECT_EQ(list->get<Array<int>>("ai").size(), 0);
  EXPECT_EQ(list->get<Array<std::string>>("as"), array<std::string>({"one", "two"}));
  EXPECT_EQ(list->get<long long>("ll"), 12345678901LL);
  EXPECT_EQ(list->sublist("Sub").get<int>("a"), 1);
}

TEST(Deck, ByteOrderMarkOfUtf8IsSkipped)
{
  const TemporaryDirectory directory;
  const auto list = readDeck(
    directory.write("deck.xml", "\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                "<ParameterList name=\"Asperity\">\n"
                                "  <Parameter name=\"s\" type=\"string\" value=\"caf\xC3\xA9\"/>\n"
                                "</ParameterList>\n"));
  EXPECT_EQ(list->get<std::string>("s"), "caf\xC3\xA9");
}

// A text of ASCII in two bytes a letter.
std::string utf16(std::string const& text, bool big_end_first)
{
  std::string result;
  for (const char letter : text) {
    result += big_end_first ? std::string{'\0', letter} : std::string{letter, '\0'};
  }
  return result;
}

TEST(Deck, Utf16IsNamed)
{
  const std::string text = "<ParameterList name=\"Asperity\">\n</ParameterList>\n";
  for (const bool big_end_first : {false, true}) {
    const std::string mark = big_end_first ? "\xFE\xFF" : "\xFF\xFE";
    for (auto const& begin : {std::string(), mark}) {
      expectParts(refusedText(begin + utf16(text, big_end_first)), {"is in UTF-16", "UTF-8"});
    }
  }
}

TEST(Deck, MissingFileAndDirectory)
{
  const TemporaryDirectory directory;
  expectRefusal([&] { readDeck(directory.file("none.xml")); }, {"There is no deck", "none.xml"});
  expectRefusal([&] { readDeck(directory.file("")); }, {"is a directory"});
}

TEST(Deck, MalformedFilesNameFileAndLine)
{
  expectParts(refusedText(""), {"deck.xml", "empty"});
  expectParts(refusedText("hello\n"), {"deck.xml", "line 1"});
  expectParts(
    refusedText(
      "<ParameterList name=\"Asperity\">\n<ParameterList name=\"a\">\n</ParameterList>\n"),
    {"deck.xml", "line", "'ParameterList'"});
  expectParts(refusedText("<ParameterList name=\"Asperity\">\n</ParameterLis>\n"),
              {"deck.xml", "line 2", "'ParameterLis'"});
  expectParts(
    refusedText(
      "<ParameterList name=\"Asperity\">\n<Parameter name=\"a value=\"1\"/>\n</ParameterList>"),
    {"deck.xml", "line 2"});
  expectParts(refusedContent("<Parameter name=\"a\" type=\"string\" value=\"x < 1 ? 2 : 3\"/>\n"),
              {"line 2", "write &lt; for <"});
  expectParts(refusedContent("<!-- two -- hyphens -->\n"), {"line 2", "must not contain '--'"});
}

TEST(Deck, ListsInListsWithoutEndAreRefused)
{
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) {
      text += "<ParameterList name=\"a > b\"><!-- <a> -->";
    }
    for (int i = 0; i < depth; ++i) {
      text += "</ParameterList>";
    }
    return text;
  };
  EXPECT_TRUE(readContent(nested(99))->isSublist("a > b"));
  expectParts(refusedContent(nested(100)), {"deck.xml", "more than 100 deep"});
  expectParts(refusedContent(nested(200000)), {"deck.xml", "more than 100 deep"});
  std::string flat;
  for (int i = 0; i < 300; ++i) {
    const auto name = std::to_string(i);
    flat += "<ParameterList name=\"l" + name + "\"/><Parameter name='p" + name +
            "' type='string' value='a/>b'></Parameter>";
  }
  EXPECT_EQ(readContent(flat)->numParams(), 600);
}

TEST(Deck, MalformedMessageIsOneLineWithoutTheToolkitsHeader)
{
  const auto message = refusedText("hello\n");
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(message.find("Throw"), std::string::npos) << message;
}

TEST(Deck, WrongRoot)
{
  expectParts(refusedText("<ParameterList name=\"Tremor\"></ParameterList>"),
              {"deck.xml", "<ParameterList name=\"Asperity\">", "Tremor"});
  expectParts(refusedText("<ParameterList></ParameterList>"),
              {"<ParameterList name=\"Asperity\">"});
  expectParts(refusedText("<html name=\"Asperity\"></html>"), {"<html"});
}

TEST(Deck, EntriesThatSayTooLittleOrTooMuch)
{
  expectParts(refusedContent("<Parametr name=\"a\"/>"),
              {"Asperity: <Parametr> is unknown", "<Parameter>"});
  expectParts(refusedContent("<Parameter type=\"int\" value=\"1\"/>"), {"no attribute 'name'"});
  expectParts(refusedContent("<Parameter name=\"a\" value=\"1\"/>"),
              {"Asperity / a", "no attribute 'type'"});
  expectParts(refusedContent("<Parameter name=\"a\" type=\"int\"/>"),
              {"Asperity / a", "no attribute 'value'"});
  expectParts(refusedContent("<Parameter name=\"a\" type=\"integral\" value=\"1\"/>"),
              {"Asperity / a", "integral"});
  expectParts(
    refusedContent("<ParameterList name=\"F\"><Parameter name=\"a\" type=\"int\" value=\"1\"/>"
                   "<Parameter name=\"a\" type=\"int\" value=\"2\"/></ParameterList>"),
    {"Asperity / F / a is given twice"});
}

TEST(Deck, ValuesThatAreNotOfTheirType)
{
  const auto refused = [](std::string const& type, std::string const& value) {
    return refusedContent("<Parameter name=\"a\" type=\"" + type + "\" value=\"" + value + "\"/>");
  };
  expectParts(refused("double", ""), {"Asperity / a", "'double'"});
  expectParts(refused("double", "nan"), {"'nan'", "'double'"});
  expectParts(refused("int", "1.5"), {"'1.5'", "'int'"});
  expectParts(refused("int", "99999999999"), {"'99999999999'", "'int'"});
  expectParts(refused("bool", "maybe"), {"'maybe'", "'bool'"});
  expectParts(refused("Array(double)", "{1, two}"), {"'{1, two}'", "'Array(double)'"});
  expectParts(refused("Array(int)", "1, 2"), {"'1, 2'", "'Array(int)'"});
}

TEST(Deck, OverlayRemoves)
{
  const TemporaryDirectory directory;
  auto list = readContent(R"(
    <ParameterList name="a"> <Parameter name="one" type="int" value="1"/> </ParameterList>
    <ParameterList name="b"> <Parameter name="two" type="int" value="2"/> </ParameterList>
    <Parameter name="c" type="int" value="3"/>)");
  overlayDeck(*list, directory.write("overlay.xml", R"(<ParameterList name="Asperity">
    <Remove name="a"/>
    <ParameterList name="a"> <Parameter name="three" type="int" value="3"/> </ParameterList>
    <ParameterList name="b"> <Remove name="two"/> </ParameterList>
    <Remove name="c"/>
  </ParameterList>)"));
  EXPECT_FALSE(list->sublist("a").isParameter("one"));
  EXPECT_EQ(list->sublist("a").get<int>("three"), 3);
  EXPECT_EQ(list->sublist("b").numParams(), 0);
  EXPECT_FALSE(list->isParameter("c"));
  const auto wrong = directory.write("wrong.xml", R"(<ParameterList name="Asperity">
    <ParameterList name="a"> <Remove name="thee"/> </ParameterList> </ParameterList>)");
  expectRefusal([&] { overlayDeck(*list, wrong); },
                {"wrong.xml", "Asperity / a / thee", "no such entry", "Did you mean 'three'?"});
}

TEST(Deck, OverlayReplacesAndExtends)
{
  const TemporaryDirectory directory;
  const auto list =
    readContent("<Parameter name=\"a\" type=\"int\" value=\"1\"/><ParameterList name=\"F\">"
                "<Parameter name=\"b\" type=\"int\" value=\"2\"/>"
                "<Parameter name=\"c\" type=\"double\" value=\"3\"/></ParameterList>");
  overlayDeck(*list,
              directory.write("short.xml",
                              "<ParameterList name=\"Asperity\"><ParameterList name=\"F\">"
                              "<Parameter name=\"c\" type=\"string\" value=\"3 + x\"/>"
                              "<Parameter name=\"d\" type=\"int\" value=\"4\"/></ParameterList>"
                              "<ParameterList name=\"a\"/></ParameterList>"));
  EXPECT_TRUE(list->isSublist("a"));
  EXPECT_EQ(list->sublist("F").get<int>("b"), 2);
  EXPECT_EQ(list->sublist("F").get<std::string>("c"), "3 + x");
  EXPECT_EQ(list->sublist("F").get<int>("d"), 4);
}

TEST(Deck, WrittenListReadsBackTheSame)
{
  const auto valid =
    Declare()
      .real("tenth", 0.1, "m", Range::any(), "A number.")
      .real("small", 1e-300, "m", Range::any(), "A number.")
      .field("field", "x < 1 && \"y\" > 2", "m", Range::any(), "An expression.")
      .realArray("array", std::vector<double>{0.1, 1.0 / 3.0}, "m", Range::any(), "Some.")
      .textArray("words", std::vector<std::string>{"a", "b c"}, "Some.")
      .integer("count", 7, Range::any(), "Some.")
      .sublist("Sub", Declare().boolean("flag", true, "Flag.").list(), "List.")
      .list();
  ParameterList list("Asperity");
  list.sublist("field").set("upper", 1);
  completeAndValidate(list, *valid, "Asperity");
  const TemporaryDirectory directory;
  writeParameters(list, directory.file("parameters.xml"));
  const auto again = readDeck(directory.file("parameters.xml"));
  EXPECT_TRUE(Teuchos::haveSameValues(list, *again, true));
  completeAndValidate(*again, *valid, "Asperity");
  EXPECT_TRUE(Teuchos::haveSameValues(list, *again, true));
  EXPECT_EQ(again->get<double>("tenth"), 0.1);
  EXPECT_EQ(again->get<double>("small"), 1e-300);
  EXPECT_EQ(again->get<Array<double>>("array")[1], 1.0 / 3.0);
}

// Whether the deck gives them or not; a value of another one is none.
TEST(Deck, WrittenListMarksDefaults)
{
  const auto valid = Declare()
                       .real("left out", 0.1, "m", Range::any(), "A number.")
                       .real("given", 0.1, "m", Range::any(), "A number.")
                       .real("changed", 0.1, "m", Range::any(), "A number.")
                       .field("field", 3.0, "m", Range::any(), "A field.")
                       .realArray("array", std::vector<double>{1, 2}, "m", Range::any(), "Some.")
                       .real("required", required, "m", Range::any(), "A number.")
                       .list();
  ParameterList list("Asperity");
  list.set("given", 0.1);
  list.set("changed", 0.2);
  list.set("field", "x");
  list.set("required", 0.1);
  completeAndValidate(list, *valid, "Asperity");
  EXPECT_EQ(list.getEntry("left out").docString(), "A number.");
  const TemporaryDirectory directory;
  writeParameters(list, directory.file("parameters.xml"));
  std::ifstream file(directory.file("parameters.xml"));
  std::map<std::string, bool> marked;
  for (std::string line; std::getline(file, line);) {
    const auto begin = line.find("<Parameter name=\"");
    if (begin != std::string::npos) {
      const std::string rest = line.substr(begin + 17);
      marked[rest.substr(0, rest.find('"'))] = line.find("isDefault=\"true\"") != std::string::npos;
    }
  }
  const std::map<std::string, bool> expected{{"left out", true}, {"given", true},
                                             {"changed", false}, {"field", false},
                                             {"array", true},    {"required", false}};
  EXPECT_EQ(marked, expected);
}

TEST(Deck, WritingWhereNothingCanBeWritten)
{
  const std::string file = "/nowhere/at/all/parameters.xml";
  asperity::test::expectRefusal<OutputError>(
    [&] { writeParameters(ParameterList("Asperity"), file); }, {file, "cannot be written"});
}

Teuchos::RCP<ParameterList> printedParameters()
{
  return Declare()
    .real("Step", 0.5, "s", Range::above(0), "The step.")
    .hint("Try 1e-3.")
    .field("Density", required, "kg/m^3", Range::positive(), "Mass density -- of rock.")
    .openSublist("Regions", Declare().text("<region>", required, "Condition.").list(),
                 "Regions of the body.")
    .choiceOfLists("Law", "A", {{"A", Declare().integer("n", 1, Range::atLeast(1), "N.").list()}},
                   "The law.")
    .list();
}

TEST(PrintParameters, TextHasDefaultUnitRangeAndMeaning)
{
  std::ostringstream out;
  printParameters(*printedParameters(), out, ParameterFormat::text);
  expectParts(out.str(), {"Asperity\n", "Step", "default 0.5", "(0, inf) s", "Unit: s.",
                          "The step.", "Try 1e-3.", "Density", "required", "Mass density",
                          "Asperity / Regions", "<region>", "'A'", "Asperity / A", "[1, inf)"});
}

TEST(PrintParameters, XmlIsADeck)
{
  std::ostringstream out;
  printParameters(*printedParameters(), out, ParameterFormat::xml);
  expectParts(out.str(), {"The step.", "(0, inf) s", "Mass density - - of rock.", "<region>"});
  const TemporaryDirectory directory;
  const auto deck = readDeck(directory.write("deck.xml", out.str()));
  EXPECT_EQ(deck->get<double>("Step"), 0.5);
  EXPECT_FALSE(deck->isParameter("Density")); // required: the user's to give
  deck->set("Density", 1.0);
  completeAndValidate(*deck, *printedParameters(), "Asperity");
  EXPECT_EQ(deck->sublist("A").get<int>("n"), 1);
}
} // namespace
