#include "scenario/setup/friction/LawSetup.hpp"

#include "friction/Registry.hpp"
#include "friction/laws/AgeingLaw.hpp"
#include "friction/laws/NoFriction.hpp"
#include "friction/laws/RegularisedLaw.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/ParameterTable.hpp"
#include "scenario/setup/friction/SteadyFriction.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
const std::string friction_choice = "Law";
const std::string state_choice = "State Evolution";

// They join those of the list.
Entries<LawChoice> lawEntries(ParameterList& list)
{
  Entries<LawChoice> entries({friction::RegularisedLaw::name, friction::AgeingLaw::name}, list);
  addLaws(entries, friction_choice, &LawChoice::friction, friction::frictionLaws(),
          "Selects the law that gives the friction coefficient from slip rate and state. None, "
          "the default where no fault has friction: the fault bears its cohesion alone.");
  addLaws(entries, state_choice, &LawChoice::state, friction::stateLaws(),
          "Selects the law by which the state evolves.",
          [](friction::StateLaw const& law, Declare& declare) {
            if (law.has_table) {
              declareSteadyFriction(declare);
            }
          });
  return entries;
}
} // namespace

void declareLaws(Declare& declare) { lawEntries(*declare.list()); }

LawChoice LawChoice::from(ParameterList const& list)
{
  ParameterList declared;
  return lawEntries(declared).read(list, friction_path);
}

namespace
{
template <class Registry>
bool hasParameter(Registry const& laws, std::string const& name)
{
  auto const names = laws.names();
  return std::any_of(names.begin(), names.end(), [&](auto const& law) {
    auto const& parameters = laws.at(law).parameters;
    return std::any_of(parameters.begin(), parameters.end(),
                       [&](auto const& parameter) { return name == parameter.name; });
  });
}

// Whether a law has a parameter of this name.
bool isOfLaw(std::string const& name)
{
  return hasParameter(friction::frictionLaws(), name) || hasParameter(friction::stateLaws(), name);
}
} // namespace

void chooseLaws(ParameterList& friction, bool is_needed)
{
  const auto chooseNone = [&friction](std::string const& entry, char const* none) {
    friction.setEntry(entry, Teuchos::ParameterEntry(std::string(none), true));
  };
  // None, or left out: parameters.xml of a run without friction has None.
  const auto isNone = [&friction](std::string const& entry, char const* none) {
    return !friction.isParameter(entry) ||
           (friction.isType<std::string>(entry) && friction.get<std::string>(entry) == none);
  };
  const bool names_law = !isNone(friction_choice, friction::NoFriction::name) ||
                         !isNone(state_choice, friction::NoState::name) ||
                         std::any_of(friction.begin(), friction.end(),
                                     [](auto const& entry) { return isOfLaw(entry.first); });
  if (!is_needed && !names_law) {
    chooseNone(friction_choice, friction::NoFriction::name);
  }
  if (isNone(state_choice, friction::NoState::name) &&
      friction.isType<std::string>(friction_choice) &&
      friction.get<std::string>(friction_choice) == friction::NoFriction::name) {
    chooseNone(state_choice, friction::NoState::name);
  }
}

bool LawChoice::hasFrictionLaw() const { return friction != asperity::friction::NoFriction::name; }

bool LawChoice::hasState() const
{
  return std::string(frictionLaw().state_variable) != asperity::friction::no_state;
}

asperity::friction::FrictionLaw const& LawChoice::frictionLaw() const
{
  return asperity::friction::frictionLaws().at(friction);
}

asperity::friction::StateLaw const& LawChoice::stateLaw() const
{
  return asperity::friction::stateLaws().at(state);
}

void requireSameState(LawChoice const& chosen)
{
  const std::string needed = chosen.frictionLaw().state_variable;
  const std::string evolves = chosen.stateLaw().state_variable;
  if (needed == evolves) {
    return;
  }
  std::string others;
  auto const& laws = friction::stateLaws();
  for (auto const& name : laws.names()) {
    if (needed == laws.at(name).state_variable) {
      others += (others.empty() ? "" : ", ") + name;
    }
  }
  throw InputError(joinPath(friction_path, state_choice) + " = " + chosen.state + " evolves the " +
                   evolves + ", but " + joinPath(friction_path, friction_choice) + " = " +
                   chosen.friction + " depends on the " + needed +
                   ". State laws for it: " + others + ".");
}

void requireState(LawChoice const& laws, std::string const& needed, std::string const& what)
{
  ASPERITY_REQUIRE(needed == laws.frictionLaw().state_variable,
                   what << " changes the " << needed << ", but "
                        << joinPath(friction_path, friction_choice) << " = " << laws.friction
                        << " depends on the " << laws.frictionLaw().state_variable << ".");
}

friction::TableView stateTable(LawChoice const& laws, ParameterList const& list)
{
  return laws.stateLaw().has_table ? steadyFriction(list) : friction::TableView();
}
} // namespace asperity::scenario
