#pragma once

#include "base/Warning.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/deck/CommandLine.hpp"

#include <optional>
#include <string>

// What looks like a mistake in a deck, by what its user wrote.
namespace asperity::scenario
{
// A warning about entries of `complete`, the deck of readCompleteDeck, that nothing reads since a
// choice has not selected their list. What an overlay or override has put out of force is no
// mistake: entries that are read with the same value before it is applied are left out, and at a
// restart all that the deck itself has, of which the run has warned. None if the deck cannot be
// read anew.
std::optional<Warning> warnOfUnreadEntries(CommandLine const& command_line,
                                           ParameterList const& complete);

// Addition to a message that refuses a deck: a line with the parameters, as the user wrote them,
// that have a finite number beyond 1e100; empty if there are none. Such a number is usually a
// mistake, and the message often names another quantity that follows from it. Parameters that the
// message names already are left out. Throws nothing.
std::string remarkOnLargeValues(CommandLine const& command_line, std::string const& message);
} // namespace asperity::scenario
