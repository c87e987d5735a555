#pragma once

#include "parameters/ParameterInfo.hpp"

// Entries that belong to one word of a choice (Declare::entriesWith). `valid` has them in a list
// of the name "<choice> = <word>".
namespace asperity
{
inline constexpr char const* alternative_separator = " = ";

// Whether a declared entry is such a list.
bool isAlternative(Teuchos::ParameterEntry const& declared);

// The word that `list`, which stands at `path`, has for a choice, given or by default. InputError
// if it is no text or not one of the declared words.
std::string chosenWord(ParameterList const& valid, ParameterList const& list,
                       std::string const& choice, std::string const& path);

// The declarations that hold for `list`, which stands at `path`: entries of the words that its
// choices have, as given or by default, stand among the others. An entry that two words bring has
// to have the same unit and default in both; the numbers that both allow are allowed. If two
// contradict each other, which is an error in the program, std::logic_error is thrown.
Teuchos::RCP<const ParameterList>
withChosenEntries(ParameterList const& valid, ParameterList const& list, std::string const& path);

// InputError for a name that is not in `chosen`, as withChosenEntries has it from `valid`, with the
// nearest name, or the word of a choice that brings an entry of the name.
[[noreturn]] void refuseUnknownName(ParameterList const& chosen, ParameterList const& valid,
                                    std::string const& path, std::string const& name);
} // namespace asperity
