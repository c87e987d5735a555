#pragma once

#include "friction/Registry.hpp"
#include "friction/Table.hpp"
#include "parameters/Parameters.hpp"

#include <string>

// The friction law and the state law that the deck's list `Friction` chooses among all that are
// registered.
namespace asperity::scenario
{
// Declares the choices of the two laws, and for every law the parameters of its table.
void declareLaws(Declare& declare);

// Completes the choices of a list `Friction` that need not be complete otherwise. The friction law
// becomes None where no fault has friction (is_needed = false) and the list has neither a law nor a
// parameter of one; the state law becomes None where the friction law is None.
void chooseLaws(ParameterList& friction, bool is_needed);

// The names of the two laws.
struct LawChoice
{
  std::string friction, state;

  static LawChoice from(ParameterList const& list);

  bool hasFrictionLaw() const; // the friction law is not None
  bool hasState() const;       // the friction law depends on a state
  asperity::friction::FrictionLaw const& frictionLaw() const;
  asperity::friction::StateLaw const& stateLaw() const;
};

// Throws InputError unless the friction law depends on the state that the state law evolves.
void requireSameState(LawChoice const& laws);
// Throws InputError unless the friction law depends on the state variable `needed`; `what` is the
// path of the process that changes it.
void requireState(LawChoice const& laws, std::string const& needed, std::string const& what);

// The table of steady friction of the state law, from the deck's list `Friction`; empty if it has
// none.
friction::TableView stateTable(LawChoice const& laws, ParameterList const& list);
} // namespace asperity::scenario
