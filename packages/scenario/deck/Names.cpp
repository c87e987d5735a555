#include "scenario/deck/Names.hpp"

#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "base/fields/Expression.hpp"
#include "base/fields/VertexDataset.hpp"
#include "base/parameters/Alternatives.hpp"
#include "base/parameters/ParameterValue.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

namespace asperity::scenario
{
using Teuchos::ParameterEntry;

namespace
{
bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::size_t endOfNumber(std::string const& text, std::size_t i)
{
  while (i < text.size() && (isDigit(text[i]) || text[i] == '.')) {
    ++i;
  }
  std::size_t after = i;
  if (after < text.size() && (text[after] == 'e' || text[after] == 'E')) {
    ++after;
    after += after < text.size() && (text[after] == '+' || text[after] == '-') ? 1 : 0;
    while (after < text.size() && isDigit(text[after])) {
      i = ++after;
    }
  }
  return i;
}

std::size_t endOfWord(std::string const& text, std::size_t i)
{
  while (i < text.size() && (isLetter(text[i]) || isDigit(text[i]))) {
    ++i;
  }
  return i;
}

bool isCalled(std::string const& text, std::size_t end)
{
  const auto next = text.find_first_not_of(' ', end);
  return next != std::string::npos && text[next] == '(';
}

constexpr std::size_t longest_text = 20000; // muParser reads no longer texts
constexpr std::size_t most_levels = 100;

// The names of a deck, each with its text, in which other names are replaced.
class Names
{
  using Open = std::vector<std::string>; // the names that are being replaced

public:
  explicit Names(ParameterList const& list)
  {
    for (auto const& name : namesIn(list)) {
      const auto path = joinPath(joinPath("Asperity", names_list), name);
      checkName(name, path);
      auto const& entry = list.getEntry(name);
      const auto number = numberIn(entry);
      ASPERITY_REQUIRE(
        number || (holds<std::string>(entry) && !VertexDataset::isName(get<std::string>(entry))),
        path << " = " << valueText(entry) << " is " << typeText(entry)
             << ", but a number or an expression is wanted.");
      texts_[name] = number ? formatNumber(*number) : get<std::string>(entry);
    }
    for (auto const& [name, text] : texts_) {
      Expression(expanded(text, Open{name}), joinPath(joinPath("Asperity", names_list), name));
    }
    used_.clear();
  }

  bool areIn(std::string const& text) const
  {
    const auto before = used_;
    const bool found = expanded(text, Open()) != text;
    used_ = before;
    return found;
  }

  // path: of the entry that has the text, for messages.
  std::string expanded(std::string const& text, std::string const& path) const
  {
    path_ = path;
    return expanded(text, Open());
  }

  bool isUsed(std::string const& name) const { return used_.count(name) > 0; }

  std::vector<std::string> all() const
  {
    std::vector<std::string> names;
    for (auto const& item : texts_) {
      names.push_back(item.first);
    }
    return names;
  }

private:
  static void checkName(std::string const& name, std::string const& path)
  {
    ASPERITY_REQUIRE(isLetter(name[0]) && endOfWord(name, 0) == name.size(),
                     path << ": '" << name
                          << "' cannot be used in an expression. Use letters, digits and _, "
                             "and begin with a letter.");
    const auto taken = Expression::reservedNames();
    ASPERITY_REQUIRE(std::find(taken.begin(), taken.end(), name) == taken.end(),
                     path << ": '" << name << "' has a meaning in expressions already. "
                          << "Take another name.");
  }

  std::string expanded(std::string const& text, Open const& open) const
  {
    std::string result;
    bool has_names = false;
    for (std::size_t i = 0; i < text.size();) {
      std::size_t end = i + 1;
      if (isDigit(text[i]) || text[i] == '.') {
        end = endOfNumber(text, i);
      } else if (isLetter(text[i])) {
        end = endOfWord(text, i);
      }
      const auto word = text.substr(i, end - i);
      const bool is_name = texts_.count(word) > 0 && !isCalled(text, end);
      has_names = has_names || is_name;
      result += is_name ? "(" + replaced(word, open) + ")" : word;
      ASPERITY_REQUIRE(
        result.size() <= longest_text,
        (open.empty() ? path_ : "Asperity / Names / " + open.back())
          << ": '" << excerpt(text) << "' has more than " << longest_text << " characters"
          << (open.empty() && !has_names ? "."
                                         : " when its names are replaced. A chain of "
                                           "names that each use the next one twice doubles the "
                                           "text with every name."));
      i = end;
    }
    return result;
  }

  std::string replaced(std::string const& name, Open open) const
  {
    const bool is_circle = std::find(open.begin(), open.end(), name) != open.end();
    ASPERITY_REQUIRE(!is_circle, "Asperity / Names / " << name << " needs its own value to be "
                                                       << "computed. Remove this loop.");
    ASPERITY_REQUIRE(open.size() < most_levels,
                     "Asperity / Names / " << open.front() << " needs more than " << most_levels
                                           << " names, one inside the other, "
                                           << "down to '" << name << "'. Shorten the chain.");
    used_.insert(name);
    open.push_back(name);
    return expanded(texts_.at(name), open);
  }

  std::map<std::string, std::string> texts_;
  mutable std::set<std::string> used_;
  mutable std::string path_ = "Asperity / Names"; // of what is being expanded
};

// The pieces between commas, except commas in brackets.
std::vector<std::string> pieces(std::string const& text)
{
  std::vector<std::string> result(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0) {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

// Empty if the text is not a constant: the check of the type then refuses it with a message.
std::optional<double> constantIn(std::string const& text, std::string const& path, bool has_names)
{
  try {
    const Expression expression(text, path);
    if (!expression.dependsOnSpace() && !expression.dependsOnTime()) {
      return expression({0, 0, 0}, 0);
    }
  } catch (InputError const&) {
    if (has_names) {
      throw;
    }
  }
  return std::nullopt;
}

void resolveNumber(ParameterEntry& entry, Names const& names, std::string const& path)
{
  const auto text = get<std::string>(entry);
  if (const auto value = constantIn(names.expanded(text, path), path, names.areIn(text))) {
    entry = ParameterEntry(*value);
  }
}

void resolveArray(ParameterEntry& entry, Names const& names, std::string const& path)
{
  const auto text = trimmed(get<std::string>(entry));
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') {
    return;
  }
  Teuchos::Array<double> values;
  for (auto const& piece : pieces(text.substr(1, text.size() - 2))) {
    const auto value = constantIn(names.expanded(piece, path), path, names.areIn(piece));
    if (!value) {
      return;
    }
    values.push_back(*value);
  }
  entry = ParameterEntry(values);
}

void resolveField(ParameterEntry& entry, Names const& names, std::string const& path)
{
  if (entry.isList()) {
    auto& regions = Teuchos::getValue<ParameterList>(entry);
    for (auto const& region : namesIn(regions)) {
      resolveField(regions.getEntry(region), names, joinPath(path, region));
    }
  } else if (holds<std::string>(entry) && !VertexDataset::isName(get<std::string>(entry))) {
    replaceValue(entry, names.expanded(get<std::string>(entry), path));
  }
}

void resolveIn(ParameterList& list, ParameterList const& valid, Names const& names,
               std::string const& path);

void resolveEntry(ParameterEntry& entry, ParameterEntry const& declared, Names const& names,
                  std::string const& path)
{
  const auto info = Teuchos::rcp_dynamic_cast<const ParameterInfo>(declared.validator());
  if (info.is_null()) {
    return;
  }
  if (info->kind == ParameterKind::field) {
    resolveField(entry, names, path);
  } else if (info->kind == ParameterKind::real && holds<std::string>(entry)) {
    resolveNumber(entry, names, path);
  } else if (info->kind == ParameterKind::real_array && holds<std::string>(entry)) {
    resolveArray(entry, names, path);
  } else if (entry.isList() && declared.isList()) {
    auto& content = Teuchos::getValue<ParameterList>(entry);
    auto const& valid = get<ParameterList>(declared);
    if (info->kind == ParameterKind::open_sublist) {
      for (auto const& name : namesIn(content)) {
        resolveEntry(content.getEntry(name), valid.entry(valid.begin()), names,
                     joinPath(path, name));
      }
    } else if (info->kind != ParameterKind::foreign_sublist) {
      resolveIn(content, valid, names, path);
    }
  }
}

void resolveIn(ParameterList& list, ParameterList const& with_all, Names const& names,
               std::string const& path)
{
  const auto valid = withChosenEntries(with_all, list, path);
  for (auto const& name : namesIn(list)) {
    if (valid->isParameter(name)) { // unknown names are refused later
      resolveEntry(list.getEntry(name), valid->getEntry(name), names, joinPath(path, name));
    }
  }
}

ParameterList takeNames(ParameterList& deck)
{
  if (!deck.isParameter(names_list)) {
    return {};
  }
  ASPERITY_REQUIRE(deck.isSublist(names_list), "Asperity / Names is not a list.");
  const ParameterList names = deck.sublist(names_list);
  deck.remove(names_list);
  return names;
}
} // namespace

RCP<const ParameterList> nameParameters()
{
  return Declare()
    .field("<name>", required, "-", Range::any(),
           "This number or expression replaces the name wherever a field, a number or an array of "
           "numbers uses it.")
    .list();
}

std::string meaningOfNames()
{
  std::string functions;
  for (auto const& name : Expression::functionNames()) {
    functions += (functions.empty() ? "" : ", ") + name;
  }
  return "Each entry in here, of any name, is a number or an expression that other parameters may "
         "use. Instead of a number, a parameter may have a text with an expression of names and "
         "numbers, such as \"slope * 3600\" or \"{slope, -1}\"; parameters.xml has the values in "
         "their places. Expressions may "
         "use x, y, z, t, pi, e, + - * / ^, comparisons, && || !, c ? a : b, and the functions " +
         functions + " (log is the natural logarithm).";
}

void resolveNames(ParameterList& deck, ParameterList const& valid,
                  std::vector<std::string> const& to_be_used)
{
  const Names names(takeNames(deck));
  resolveIn(deck, valid, names, "Asperity");
  for (auto const& name : to_be_used) {
    auto others = names.all();
    others.erase(std::remove(others.begin(), others.end(), name), others.end());
    ASPERITY_REQUIRE(names.isUsed(name), "Asperity / Names / " << name
                                                               << " is used nowhere in the deck."
                                                               << didYouMean(name, others));
  }
}
} // namespace asperity::scenario
