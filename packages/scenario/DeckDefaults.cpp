#include "scenario/DeckDefaults.hpp"

#include "scenario/setup/TimeSchemes.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/friction/LawSetup.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <string>

namespace asperity::scenario
{
namespace
{
// Whether `name` can be taken as a list: it is one, or the deck has nothing of that name.
bool isListOrMissing(ParameterList const& deck, char const* name)
{
  return deck.isSublist(name) || !deck.isParameter(name);
}

void chooseDefaultLaws(ParameterList& deck)
{
  const bool has_friction =
    deck.isSublist("Boundary Conditions") && haveFriction(deck.sublist("Boundary Conditions"));
  // A fault with friction needs the list, which is not made here.
  if (has_friction ? deck.isSublist("Friction") : isListOrMissing(deck, "Friction")) {
    chooseLaws(deck.sublist("Friction"), has_friction);
  }
}

void chooseDefaultScheme(ParameterList& deck)
{
  constexpr char const* list = "Time Stepping";
  constexpr char const* entry = time_entries::scheme;
  const bool is_quasi_dynamic = deck.isSublist("Bulk") && choosesQuasiDynamic(deck.sublist("Bulk"));
  if (is_quasi_dynamic && isListOrMissing(deck, list) && !deck.sublist(list).isParameter(entry)) {
    deck.sublist(list).setEntry(entry, Teuchos::ParameterEntry(std::string(massless_scheme), true));
  }
}
} // namespace

void chooseDefaults(ParameterList& deck)
{
  chooseDefaultLaws(deck);
  chooseDefaultScheme(deck);
}
} // namespace asperity::scenario
