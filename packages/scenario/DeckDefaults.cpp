#include "scenario/DeckDefaults.hpp"

#include "scenario/setup/DeckPaths.hpp"
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
    deck.isSublist(deck_lists::conditions) && haveFriction(deck.sublist(deck_lists::conditions));
  // A fault with friction needs the list, which is not made here.
  if (has_friction ? deck.isSublist(deck_lists::friction)
                   : isListOrMissing(deck, deck_lists::friction)) {
    chooseLaws(deck.sublist(deck_lists::friction), has_friction);
  }
}

void chooseDefaultScheme(ParameterList& deck)
{
  constexpr char const* list = deck_lists::time;
  constexpr char const* entry = time_entries::scheme;
  const bool is_quasi_dynamic =
    deck.isSublist(deck_lists::bulk) && choosesQuasiDynamic(deck.sublist(deck_lists::bulk));
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
