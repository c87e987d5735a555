#pragma once

#include "base/Types.hpp"
#include "parameters/Parameters.hpp"
#include "parameters/fields/Expression.hpp"

#include <string>

namespace asperity::scenario
{
// The list of a deck in which it names functions of one variable, to call them in expressions:
//
//   <ParameterList name="Tables">
//     <ParameterList name="density">
//       <Parameter name="Arguments" type="Array(double)" value="{0, 5e3, 35e3}"/>
//       <Parameter name="Values" type="Array(double)" value="{2400, 2700, 3300}"/>
//     </ParameterList>
//   </ParameterList>
inline constexpr char const* tables_list = "Tables";

// For Declare::openSublist(tables_list, ...): the entries of a table, and what the list is for.
RCP<const ParameterList> tableParameters();
std::string meaningOfTables();

// The functions of the tables of a deck with that list, whose numbers are numbers already; null if
// the list is empty.
// Each rank reads the files. InputError for a list that is not valid, a name that formulas have
// already, and for rows that make no function.
Expression::Tables readTables(ParameterList const& deck);

// Lets the fields of a completed deck call the functions.
void giveTables(ParameterList& deck, Expression::Tables const& tables);
} // namespace asperity::scenario
