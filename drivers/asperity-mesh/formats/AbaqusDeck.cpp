#include "formats/AbaqusDeck.hpp"

#include "surfaces/files/TextFile.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cctype>

namespace asperity::geometry
{
namespace
{
std::string unquoted(std::string const& text)
{
  const auto inside = trimmed(text);
  return inside.size() > 1 && inside.front() == '"' && inside.back() == '"'
           ? inside.substr(1, inside.size() - 2)
           : inside;
}

// "*ELEMENT, TYPE=C3D4, ELSET=rock"; names are in upper case, values as they are.
struct Keyword
{
  explicit Keyword(std::string const& line)
  {
    for (auto const& piece : split(line.substr(1), ',')) {
      const auto equals = piece.find('=');
      const auto key = upperCase(trimmed(piece.substr(0, equals)));
      if (name.empty()) {
        name = key;
      } else {
        values[key] = equals == std::string::npos ? "" : unquoted(piece.substr(equals + 1));
      }
    }
  }
  std::string value(std::string const& key) const
  {
    const auto found = values.find(key);
    return found == values.end() ? "" : found->second;
  }

  std::string name;
  std::map<std::string, std::string> values;
};

// 3 for cells in space, 2 for those in the plane and shells, 1 for lines, -1 for what is unknown.
int dimensionOfType(std::string const& type)
{
  static const std::vector<std::pair<std::string, int>> begins = {
    {"C3D", 3},  {"DC3D", 3},  {"CPE", 2}, {"CPS", 2}, {"CAX", 2},   {"DC2D", 2},
    {"STRI", 2}, {"SFM3D", 2}, {"S", 2},   {"M3D", 2}, {"R3D", 2},   {"T2D", 1},
    {"T3D", 1},  {"B2", 1},    {"B3", 1},  {"R2D", 1}, {"FRAME", 1}, {"RAX", 1}};
  for (auto const& [begin, dimension] : begins) {
    if (type.rfind(begin, 0) == 0 && type.rfind("SPRING", 0) != 0) {
      return dimension;
    }
  }
  return -1;
}

class Reader
{
public:
  Reader(std::string const& file_name, AbaqusDeck& deck)
      : deck_(deck)
      , file_(file_name, "Mesh file")
  {
    deck.where = file_.where();
  }

  // Lines of data follow their keyword.
  void read()
  {
    Keyword keyword("*");
    while (file_.next()) {
      const auto line = trimmed(std::string(file_.line()));
      if (line.rfind("**", 0) == 0) {
        continue;
      }
      if (line.front() == '*') {
        requireWholeElement();
        keyword = Keyword(line);
        begin(keyword);
      } else {
        readData(keyword, line);
      }
    }
    requireWholeElement();
    ASPERITY_REQUIRE(!deck_.elements.empty(), file_.where() << " has no *ELEMENT.");
  }

private:
  void requireWholeElement() const
  {
    if (!pending_.empty()) {
      file_.fail("element " + std::to_string(pending_.front()) +
                 " ends with a comma, and no line with its other nodes follows.");
    }
  }

  void begin(Keyword const& keyword)
  {
    if (keyword.name == "INCLUDE") {
      file_.fail("*INCLUDE is not followed. Put the mesh into one file.");
    }
    if (keyword.name == "ELEMENT" && dimensionOfType(upperCase(keyword.value("TYPE"))) < 0) {
      file_.fail("elements of type '" + keyword.value("TYPE") +
                 "' cannot be read, only solids, shells, membranes and lines.");
    }
    if (keyword.name.size() > 8 && keyword.name.find(" SECTION") != std::string::npos &&
        !keyword.value("ELSET").empty()) {
      deck_.sections.push_back(keyword.value("ELSET"));
    }
    const bool has_name = keyword.name == "NSET" || keyword.name == "ELSET";
    if ((has_name && keyword.value(keyword.name).empty()) ||
        (keyword.name == "SURFACE" && keyword.value("NAME").empty())) {
      file_.fail("*" + keyword.name + " needs a name.");
    }
    if (keyword.name == "SURFACE") {
      deck_.surfaces.push_back(
        {keyword.value("NAME"), {}, upperCase(keyword.value("TYPE")) == "NODE"});
    }
  }

  void readData(Keyword const& keyword, std::string const& line)
  {
    if (keyword.name == "NODE") {
      readNode();
    } else if (keyword.name == "ELEMENT") {
      readElement(keyword, line.back() == ',');
    } else if (keyword.name == "NSET" || keyword.name == "ELSET") {
      readSet(keyword, line);
    } else if (keyword.name == "SURFACE") {
      auto words = split(line, ',');
      words.resize(2);
      deck_.surfaces.back().sides.emplace_back(unquoted(words[0]), upperCase(trimmed(words[1])));
    } else if (keyword.name == "INSTANCE") {
      file_.fail("an instance that is moved cannot be read. Merge the instances of the assembly "
                 "into one part.");
    }
  }

  void readNode()
  {
    file_.require(3, "node, x, y, z");
    const double z = file_.words().size() > 3 ? file_.number(3) : 0;
    const auto number = file_.integer(0);
    if (!deck_.nodes.emplace(number, Point<3>{file_.number(1), file_.number(2), z}).second) {
      file_.fail("node " + std::to_string(number) +
                 " is given twice. Merge the parts of the assembly into one.");
    }
  }

  // A line that ends with a comma goes on in the next one.
  void readElement(Keyword const& keyword, bool goes_on)
  {
    for (std::size_t i = 0; i < file_.words().size(); ++i) {
      pending_.push_back(file_.integer(i));
    }
    if (goes_on) {
      return;
    }
    const auto number = pending_.front();
    AbaqusDeck::Element element{dimensionOfType(upperCase(keyword.value("TYPE"))),
                                {pending_.begin() + 1, pending_.end()},
                                keyword.value("ELSET")};
    pending_.clear();
    if (!element.set.empty()) {
      setOf(deck_.element_sets, element.set).members.push_back(number);
    }
    if (!deck_.elements.emplace(number, std::move(element)).second) {
      file_.fail("element " + std::to_string(number) +
                 " is given twice. Merge the parts of the assembly into one.");
    }
  }

  static AbaqusDeck::Set& setOf(std::map<std::string, AbaqusDeck::Set>& sets,
                                std::string const& name)
  {
    auto& set = sets[upperCase(name)];
    set.name = set.name.empty() ? name : set.name;
    return set;
  }

  void readSet(Keyword const& keyword, std::string const& line)
  {
    auto& sets = keyword.name == "NSET" ? deck_.node_sets : deck_.element_sets;
    auto& set = setOf(sets, keyword.value(keyword.name));
    if (keyword.values.count("GENERATE") > 0) {
      file_.require(2, "first, last, step");
      const auto first = file_.integer(0), last = file_.integer(1);
      const auto step = file_.words().size() > 2 ? file_.integer(2) : 1;
      const auto largest = keyword.name == "NSET" ? last_of(deck_.nodes) : last_of(deck_.elements);
      if (step < 1 || first < 0 || last > largest) {
        file_.fail("the set goes from " + std::to_string(first) + " to " + std::to_string(last) +
                   " by " + std::to_string(step) + ", outside [0, " + std::to_string(largest) +
                   "].");
      }
      for (auto number = first; number <= last; number += step) {
        set.members.push_back(number);
      }
      return;
    }
    for (auto const& word : split(line, ',')) {
      const auto name = unquoted(word);
      const auto number = readInteger(name);
      const auto other = sets.find(upperCase(name));
      if (number) {
        set.members.push_back(*number);
      } else if (other != sets.end()) {
        const auto members = other->second.members; // may be of the same set
        set.members.insert(set.members.end(), members.begin(), members.end());
      } else if (!name.empty()) {
        file_.fail("'" + name + "' is neither a number nor a set before this line.");
      }
    }
  }

  template <class Value>
  static std::int64_t last_of(std::map<std::int64_t, Value> const& items)
  {
    return items.empty() ? 0 : items.rbegin()->first;
  }

  AbaqusDeck& deck_;
  TextFile file_;
  std::vector<std::int64_t> pending_; // of an element whose line goes on
};
} // namespace

std::string upperCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

AbaqusDeck::AbaqusDeck(std::string const& file_name) { Reader(file_name, *this).read(); }
} // namespace asperity::geometry
