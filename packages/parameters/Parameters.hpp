#pragma once

#include "base/Errors.hpp"
#include "parameters/DefaultOr.hpp"
#include "registry/Range.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <string>
#include <utility>
#include <vector>

namespace asperity
{
using Teuchos::ParameterList;
class ParameterInfo;

// Declares the entries of a list of valid parameters, one call per entry, each with default (or
// `required`, `optional`), unit ("-" if dimensionless), range and one sentence of meaning:
//
//   Teuchos::RCP<const ParameterList> Wedge::validParameters()
//   {
//     return Declare()
//       .real("Growth Factor", 8.0, "-", Range::atLeast(0), "Cells grow by this factor.")
//       .field("Density", required, "kg/m^3", Range::positive(), "The material has this density.")
//       .hint("Rock has 2000 to 3500 kg/m^3.") // joins the message that refuses the density
//       .list();
//   }
//
// The lists are read by completeAndValidate, applyOverride and printParameters.
class Declare
{
public:
  // Entries go to a list of its own, taken with list().
  Declare();

  // Entries go to the caller's list, which must outlive this object.
  explicit Declare(ParameterList& list);

  // A number; the deck's int is accepted and becomes a double.
  Declare& real(std::string const& name, DefaultOr<double> value, std::string const& unit,
                Range range, std::string const& meaning);
  Declare& integer(std::string const& name, DefaultOr<int> value, Range range,
                   std::string const& meaning);
  Declare& boolean(std::string const& name, DefaultOr<bool> value, std::string const& meaning);
  Declare& text(std::string const& name, DefaultOr<std::string> const& value,
                std::string const& meaning);
  Declare& fileName(std::string const& name, DefaultOr<std::string> const& value,
                    std::string const& meaning);

  // One of a few words.
  Declare& choice(std::string const& name, DefaultOr<std::string> const& value,
                  std::vector<std::string> const& words, std::string const& meaning);

  // A choice, and for each word a list of that name, of which only the chosen one is completed.
  using NamedList = std::pair<std::string, Teuchos::RCP<const ParameterList>>;
  Declare& choiceOfLists(std::string const& name, DefaultOr<std::string> const& value,
                         std::vector<NamedList> const& lists, std::string const& meaning);

  // Entries that this list has only where the choice, declared before, is this word: parameters of
  // plugins that are chosen by name. A name may be brought by several words and by several choices.
  Declare& entriesWith(std::string const& choice, std::string const& word,
                       Teuchos::RCP<const ParameterList> const& entries);

  // A number, an expression in x, y, z, t, a dataset "file.h5:/dataset", or a list with one number
  // or expression per region. Read it with Field. The range holds wherever the field is evaluated.
  Declare& field(std::string const& name, DefaultOr<FieldValue> const& value,
                 std::string const& unit, Range range, std::string const& meaning);

  // Teuchos::Array of double (of int in the deck is accepted), int, std::string; each number in the
  // range.
  Declare& realArray(std::string const& name, DefaultOr<std::vector<double>> const& value,
                     std::string const& unit, Range range, std::string const& meaning);
  Declare& integerArray(std::string const& name, DefaultOr<std::vector<int>> const& value,
                        Range range, std::string const& meaning);
  Declare& textArray(std::string const& name, DefaultOr<std::vector<std::string>> const& value,
                     std::string const& meaning);

  // A list with entries of its own; completed even where the deck leaves it out.
  Declare& sublist(std::string const& name, Teuchos::RCP<const ParameterList> const& valid,
                   std::string const& meaning);

  // A list whose entries the user names; `each` holds one declaration that all of them follow, e.g.
  // openSublist("Regions", Declare().text("<region>", required, "Condition in x and y.").list(),
  // "...").
  Declare& openSublist(std::string const& name, Teuchos::RCP<const ParameterList> const& each,
                       std::string const& meaning);

  // A list that another package validates (MueLu, Belos); missing entries are copied from the
  // defaults.
  Declare& foreignSublist(std::string const& name, ParameterList const& defaults,
                          std::string const& meaning);

  // Advice for the message that refuses the entry declared last.
  Declare& hint(std::string const& text);
  // The field declared last is needed at places that are no vertices: it cannot be a dataset.
  Declare& withoutDatasets();

  Teuchos::RCP<ParameterList> list() const { return list_; }

private:
  // Stored: the type of the value in the list.
  template <class Stored, class T>
  Declare& addValue(std::string const& name, DefaultOr<T> const& value, std::string const& meaning,
                    Teuchos::RCP<ParameterInfo> const& info);
  Declare& addList(std::string const& name, ParameterList const& content,
                   std::string const& meaning, Teuchos::RCP<ParameterInfo> const& info);

  Teuchos::RCP<ParameterList> list_;
  std::string last_;
};

// Refuses unknown names, wrong types, values out of range and missing required entries with an
// InputError that says path, value, what is allowed and the nearest valid name, a line for each of
// up to ten errors; completes the list with the defaults. `path` is where the list stands, e.g.
// "Asperity / Friction". The entries remember their range.
void completeAndValidate(ParameterList& list, ParameterList const& valid, std::string const& path);

// "Asperity / Friction" + "a" = "Asperity / Friction / a"
std::string joinPath(std::string const& path, std::string const& name);

// Whether the list has the entry, as a parameter or as a list of values per region.
bool isGiven(ParameterList const& list, std::string const& name);
} // namespace asperity
