#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "parameters/fields/Expression.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The list of a deck in which it names numbers and expressions, to use them in others:
//
//   <ParameterList name="Names">
//     <Parameter name="slope" type="double" value="0.27"/>
//     <Parameter name="zone" type="string" value="x &lt; 0.35 * sqrt(1 + slope^2)"/>
//   </ParameterList>
inline constexpr char const* names_list = "Names";

// For Declare::openSublist(names_list, ...): what an entry of the list may be, and what the list is
// for, with all that an expression may use.
RCP<const ParameterList> nameParameters();
std::string meaningOfNames();

// Replaces each name by its value in fields, numbers and arrays of numbers of the deck, and removes
// the list. Where `valid` wants a number or an array of numbers, a text such as "slope * 3600" or
// "{slope, -1}" becomes one. InputError for names that are not identifiers, that functions or
// coordinates have, or that refer to each other in a loop; also for one of `to_be_used` that
// nothing uses. Reads the deck's tables, whose entries may use names that call no table, and
// returns their functions, null if there are none. Call it before completeAndValidate.
Expression::Tables resolveNames(ParameterList& deck, ParameterList const& valid,
                                std::vector<std::string> const& to_be_used = {});
} // namespace asperity::scenario
