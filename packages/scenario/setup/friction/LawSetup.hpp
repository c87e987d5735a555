#pragma once

#include "friction/Registry.hpp"
#include "friction/Table.hpp"
#include "scenario/setup/NodalField.hpp"

#include <optional>
#include <string>
#include <vector>

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

// In all functions below, list is the deck's list `Friction`.

// Values of the chosen law's parameters at fault nodes (num_parameters, num_nodes), on the device.
friction::ParameterView frictionLawValues(LawChoice const& laws, ParameterList const& list,
                                          FieldNodes const& nodes);
friction::ParameterView stateLawValues(LawChoice const& laws, ParameterList const& list,
                                       FieldNodes const& nodes);
// The table of steady friction of the state law; empty if it has none.
friction::TableView stateTable(LawChoice const& laws, ParameterList const& list);

// Properties of the chosen laws at the nodes, see friction/LawProperties.hpp; empty if a law does
// not declare the property.
std::optional<std::vector<friction::Sensitivity>>
sensitivities(LawChoice const& laws, ParameterList const& list, FieldNodes const& nodes);
std::optional<std::vector<double>> slipDistances(LawChoice const& laws, ParameterList const& list,
                                                 FieldNodes const& nodes);
std::optional<std::vector<double>>
referenceFriction(LawChoice const& laws, ParameterList const& list, FieldNodes const& nodes);
std::optional<std::vector<double>> strengthDrops(LawChoice const& laws, ParameterList const& list,
                                                 FieldNodes const& nodes);
std::optional<std::vector<double>> thetaScales(LawChoice const& laws, ParameterList const& list,
                                               FieldNodes const& nodes);

// c / b of Linker and Dieterich's term at the nodes [-]; empty if c is zero at all of them.
// InputError where c > 0 and the friction law has no b, or b = 0.
std::vector<double> stressSensitivities(LawChoice const& laws, ParameterList const& list,
                                        FieldNodes const& nodes);
} // namespace asperity::scenario
