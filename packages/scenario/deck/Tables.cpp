#include "scenario/deck/Tables.hpp"

#include "base/Text.hpp"
#include "parameters/Entries.hpp"
#include "parameters/ParameterInfo.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/fields/TableFile.hpp"
#include "parameters/fields/TableFunction.hpp"
#include "parameters/fields/Unit.hpp"

#include <memory>
#include <utility>

namespace asperity::scenario
{
namespace
{
constexpr char const* from_entry = "From";
constexpr char const* from_deck = "Deck";
constexpr char const* from_file = "File";
constexpr char const* file_name = "File Name";
constexpr char const* argument_column = "Argument Column";
constexpr char const* value_column = "Value Column";
constexpr char const* arguments_entry = "Arguments";
constexpr char const* values_entry = "Values";
constexpr char const* argument_unit = "Argument Unit";
constexpr char const* value_unit = "Value Unit";
constexpr char const* outside_entry = "Outside";
constexpr char const* outside_value = "Value";
constexpr char const* value_outside = "Value Outside";

struct TableSettings
{
  std::string from = from_deck;
  std::string argument_unit, value_unit;
  TableRule rule;
};

RCP<const ParameterList> deckEntries()
{
  return Declare()
    .realArray(arguments_entry, required, "[Argument Unit]", Range::any(),
               "The function is known at these arguments, which ascend; 'Argument Unit' says in "
               "which unit they are.")
    .realArray(values_entry, required, "[Value Unit]", Range::any(),
               "The function has these values, one for each argument; 'Value Unit' says in which "
               "unit they are.")
    .list();
}

RCP<const ParameterList> fileEntries()
{
  return Declare()
    .fileName(file_name, required,
              "This CSV file has the table: a line that names the columns, with units in brackets "
              "such as 'depth [km], vp [km/s]', and a line for each row, with commas between the "
              "numbers. Lines that begin with # do not count. A relative name is looked for beside "
              "the deck, and then from where the program was started.")
    .text(argument_column, required,
          "The column of this name has the arguments, which ascend. A unit in brackets is no part "
          "of the name.")
    .text(value_column, required, "The column of this name has the values.")
    .list();
}

Entries<TableSettings> tableEntries()
{
  using S = TableSettings;
  using Interpolation = TableRule::Interpolation;
  using Outside = TableRule::Outside;
  Entries<S> entries;
  entries.choiceOfWords(from_entry, &S::from, {from_deck, from_file},
                        "Selects whether the deck has the rows of the table or names a file that "
                        "has them.");
  entries.others()
    .entriesWith(from_entry, from_deck, deckEntries())
    .entriesWith(from_entry, from_file, fileEntries());
  entries
    .text(argument_unit, &S::argument_unit,
          "Names the unit of the arguments, from which they are converted to SI, as in km. If it "
          "is empty, they are in the unit that the file names in brackets, or else in SI; another "
          "unit than that of the file is refused.")
    .text(value_unit, &S::value_unit,
          "Names the unit of the values in the same way, as in km/s, g/cm^3 or GPa.")
    .choice(
      "Interpolation", [](S& s) -> Interpolation& { return s.rule.interpolation; },
      {{"Linear", Interpolation::linear},
       {"Nearest", Interpolation::nearest},
       {"Step", Interpolation::step}},
      "Selects the values between rows. Linear: they vary linearly, and an argument that two "
      "rows have is a jump. Nearest: they are those of the nearest row. Step: they are those "
      "of the last row whose argument is not greater, so that a row begins a layer. Where "
      "the function jumps, it has the value of the greater arguments.")
    .choice(
      outside_entry, [](S& s) -> Outside& { return s.rule.outside; },
      {{"Error", Outside::error}, {"Nearest", Outside::nearest}, {outside_value, Outside::value}},
      "Selects what an argument before the first or behind the last row means. Error: the "
      "deck is refused. Nearest: the value is that of the first or last row. Value: it is "
      "'Value Outside'.");
  entries.others().entriesWith(
    outside_entry, outside_value,
    Declare()
      .real(value_outside, required, "SI unit", Range::any(),
            "The function has this value before the first and behind the last row.")
      .list());
  return entries;
}

TableRows rowsOfDeck(ParameterList const& list, TableSettings const& settings,
                     std::string const& path)
{
  const auto converted = [&](char const* entry, char const* unit_entry, std::string const& unit) {
    auto numbers = list.get<Teuchos::Array<double>>(entry).toVector();
    const Unit given(unit, joinPath(path, unit_entry));
    for (double& number : numbers) {
      number = given.toSi(number);
    }
    return numbers;
  };
  return {converted(arguments_entry, argument_unit, settings.argument_unit),
          converted(values_entry, value_unit, settings.value_unit), trimmed(settings.value_unit)};
}

TableRows rowsOfFile(ParameterList const& list, TableSettings const& settings,
                     std::string const& path)
{
  const auto column = [&](char const* entry, char const* unit_entry, std::string const& unit) {
    return TableFile::Column{list.get<std::string>(entry), joinPath(path, entry), trimmed(unit),
                             joinPath(path, unit_entry)};
  };
  return TableFile(list.get<std::string>(file_name), joinPath(path, file_name))
    .rows(column(argument_column, argument_unit, settings.argument_unit),
          column(value_column, value_unit, settings.value_unit));
}

TableFunction tableOf(ParameterList const& list, std::string const& path)
{
  auto settings = tableEntries().read(list, path);
  if (settings.rule.outside == TableRule::Outside::value) {
    settings.rule.value_outside = list.get<double>(value_outside);
  }
  auto rows = settings.from == from_file ? rowsOfFile(list, settings, path)
                                         : rowsOfDeck(list, settings, path);
  return TableFunction(std::move(rows), settings.rule, path);
}
} // namespace

RCP<const ParameterList> tableParameters()
{
  return Declare()
    .sublist("<function>", tableEntries().list(),
             "Names a function of one variable, and gives the table of its values.")
    .list();
}

std::string meaningOfTables()
{
  return "Each list in here is a table, and its name is a function of one variable that every "
         "expression of the deck may call: with a table density, the field density(-z) has layers. "
         "It is evaluated where the field is, with arguments and values in SI units.";
}

Expression::Tables readTables(ParameterList const& deck)
{
  ASPERITY_REQUIRE(deck.isSublist(tables_list), "Asperity / Tables is not a list.");
  ParameterList complete;
  complete.sublist(tables_list) = deck.sublist(tables_list);
  completeAndValidate(
    complete, *Declare().openSublist(tables_list, tableParameters(), "Tables.").list(), "Asperity");
  auto const path = joinPath("Asperity", tables_list);
  auto const& lists = complete.sublist(tables_list);
  auto const tables = std::make_shared<TableFunctions>();
  for (auto const& name : namesIn(lists)) {
    auto const where = joinPath(path, name);
    Expression::requireFreeName(name, where);
    tables->of_name.emplace(name, tableOf(lists.sublist(name), where));
  }
  return tables->of_name.empty() ? nullptr : tables;
}

void giveTables(ParameterList& deck, Expression::Tables const& tables)
{
  if (!tables) {
    return;
  }
  for (auto const& name : namesIn(deck)) {
    auto& entry = deck.getEntry(name);
    auto const info = parameterInfo(entry);
    if (!info.is_null() && info->kind == ParameterKind::field) {
      auto with_tables = rcp(new ParameterInfo(*info)); // other decks share the declaration
      with_tables->tables = tables;
      entry.setValidator(with_tables);
    } else if (entry.isList()) {
      giveTables(Teuchos::getValue<ParameterList>(entry), tables);
    }
  }
}
} // namespace asperity::scenario
