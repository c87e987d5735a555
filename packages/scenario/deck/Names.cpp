#include "scenario/deck/Names.hpp"

#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "parameters/Alternatives.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/fields/Expression.hpp"
#include "parameters/fields/TableFunction.hpp"
#include "parameters/fields/VertexDataset.hpp"
#include "scenario/deck/Tables.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace asperity::scenario
{
using Teuchos::ParameterEntry;

namespace
{
constexpr std::size_t longest_text = 20000; // muParser reads no longer texts
constexpr std::size_t most_levels = 100;

std::string pathOf(std::string const& name)
{
  return joinPath(joinPath("Asperity", names_list), name);
}

// The names of a deck with their texts. A name is replaced in the text of an entry, rather than
// defined as muParser's constant, so that parameters.xml has the formula that is evaluated.
class Names
{
  using Open = std::vector<std::string>; // the names that are being replaced

public:
  explicit Names(ParameterList const& list)
  {
    for (auto const& name : namesIn(list)) {
      Expression::requireFreeName(name, pathOf(name));
      auto const& entry = list.getEntry(name);
      const bool is_formula =
        holds<std::string>(entry) && !VertexDataset::isName(get<std::string>(entry));
      ASPERITY_REQUIRE(is_formula || numberIn(entry),
                       pathOf(name) << " = " << valueText(entry) << " is " << typeText(entry)
                                    << ", but a number or an expression is wanted.");
      texts_[name] = plainText(entry);
    }
  }

  // From here on they may call these functions. InputError for a name that is no formula, or that a
  // table has, too.
  void setTables(Expression::Tables const& tables)
  {
    tables_ = tables;
    auto const used = used_;
    for (auto const& [name, text] : texts_) {
      ASPERITY_REQUIRE(!tables || tables->of_name.count(name) == 0,
                       pathOf(name)
                         << ": the list Tables has '" << name << "', too. Take another name.");
      Expression(replacedIn(text, pathOf(name), {name}), pathOf(name), tables_);
    }
    used_ = used;
  }

  Expression::Tables const& tables() const { return tables_; }

  bool areIn(std::string const& text) const
  {
    auto const parts = formulaParts(text);
    return std::any_of(parts.begin(), parts.end(), [this](auto const& part) { return has(part); });
  }

  // path: of the entry that has the text, for messages.
  std::string replacedIn(std::string const& text, std::string const& path, Open const& open = {})
  {
    std::string result;
    for (auto const& part : formulaParts(text)) {
      result += has(part) ? "(" + valueOf(part.text, open) + ")" : part.text;
      ASPERITY_REQUIRE(
        result.size() <= longest_text,
        path << ": '" << excerpt(text) << "' has more than " << longest_text << " characters"
             << (open.empty() && !areIn(text)
                   ? "."
                   : " when its names are replaced. A chain of names that each use the next one "
                     "twice doubles the text with every name."));
    }
    return result;
  }

  void requireUsed(std::string const& name) const
  {
    std::vector<std::string> others;
    for (auto const& item : texts_) {
      if (item.first != name) {
        others.push_back(item.first);
      }
    }
    ASPERITY_REQUIRE(used_.count(name) > 0,
                     pathOf(name) << " is used nowhere in the deck." << didYouMean(name, others));
  }

private:
  bool has(FormulaPart const& part) const { return part.is_name && texts_.count(part.text) > 0; }

  std::string valueOf(std::string const& name, Open open)
  {
    const bool is_circle = std::find(open.begin(), open.end(), name) != open.end();
    ASPERITY_REQUIRE(!is_circle, pathOf(name)
                                   << " needs its own value to be computed. Remove this loop.");
    ASPERITY_REQUIRE(open.size() < most_levels,
                     pathOf(open.front())
                       << " needs more than " << most_levels << " names, one inside the other, "
                       << "down to '" << name << "'. Shorten the chain.");
    used_.insert(name);
    open.push_back(name);
    return replacedIn(texts_.at(name), pathOf(name), open);
  }

  std::map<std::string, std::string> texts_;
  std::set<std::string> used_;
  Expression::Tables tables_;
};

// A text that is not constant stays: the check of the type then refuses it with a message.
void resolveNumbers(ParameterEntry& entry, bool is_array, Names& names, std::string const& path)
{
  const auto whole = get<std::string>(entry);
  const auto given = is_array ? insideBraces(whole) : whole;
  if (!given) {
    return;
  }
  const auto text = names.replacedIn(*given, path);
  try {
    const auto values = Expression::constants(text, path, names.tables());
    if (values && is_array) {
      entry = ParameterEntry(Teuchos::Array<double>(*values));
    } else if (values && values->size() == 1) {
      entry = ParameterEntry(values->front());
    }
  } catch (InputError const&) {
    if (names.areIn(*given)) {
      throw;
    }
  }
}

void resolveField(ParameterEntry& entry, Names& names, std::string const& path)
{
  if (entry.isList()) {
    auto& regions = Teuchos::getValue<ParameterList>(entry);
    for (auto const& region : namesIn(regions)) {
      resolveField(regions.getEntry(region), names, joinPath(path, region));
    }
  } else if (holds<std::string>(entry) && !VertexDataset::isName(get<std::string>(entry))) {
    replaceValue(entry, names.replacedIn(get<std::string>(entry), path));
  }
}

void resolveIn(ParameterList& list, ParameterList const& valid, Names& names,
               std::string const& path);

void resolveEntry(ParameterEntry& entry, ParameterEntry const& declared, Names& names,
                  std::string const& path)
{
  const auto info = parameterInfo(declared);
  if (info.is_null()) {
    return;
  }
  if (info->kind == ParameterKind::field) {
    resolveField(entry, names, path);
  } else if ((info->kind == ParameterKind::real || info->kind == ParameterKind::real_array) &&
             holds<std::string>(entry)) {
    resolveNumbers(entry, info->kind == ParameterKind::real_array, names, path);
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

void resolveIn(ParameterList& list, ParameterList const& with_all, Names& names,
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
  return "Each entry in here, of any name, is a number or an expression that other parameters may "
         "use. Instead of a number, a parameter may have a text with an expression of names and "
         "numbers, such as \"slope * 3600\" or \"{slope, -1}\"; parameters.xml has the values in "
         "their places. Expressions may use x, y, z, t, pi, e, " +
         Expression::operations() +
         " (log is the natural logarithm; mean(f) is the mean of f over the facets around a node "
         "of a fault, in other fields f), and the functions of the list Tables.";
}

Expression::Tables resolveNames(ParameterList& deck, ParameterList const& valid,
                                std::vector<std::string> const& to_be_used)
{
  Names names(takeNames(deck));
  Expression::Tables tables;
  if (valid.isSublist(tables_list) && deck.isParameter(tables_list)) {
    resolveEntry(deck.getEntry(tables_list), valid.getEntry(tables_list), names,
                 joinPath("Asperity", tables_list));
    tables = readTables(deck);
  }
  names.setTables(tables);
  resolveIn(deck, valid, names, "Asperity");
  for (auto const& name : to_be_used) {
    names.requireUsed(name);
  }
  return tables;
}
} // namespace asperity::scenario
