#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"

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

// Puts the value of each name in its place, in fields, numbers and arrays of numbers of the deck,
// and removes the list. A text where `valid` wants a number, as "slope * 3600", or an array of
// numbers, as "{slope, -1}", becomes that. InputError for names that are no names, are those of
// functions or coordinates, or refer to each other in a circle; also for one of `to_be_used` that
// nothing uses. Call it before completeAndValidate.
void resolveNames(ParameterList& deck, ParameterList const& valid,
                  std::vector<std::string> const& to_be_used = {});
} // namespace asperity::scenario
