#pragma once

#include "friction/Table.hpp"
#include "scenario/setup/ParameterTable.hpp"

// The table of steady friction for state laws with `has_table`: two datasets of HDF5.
namespace asperity::scenario
{
void declareSteadyFriction(Declare& declare);

// The table that the deck's list `Friction` names. InputError if a dataset cannot be read, the slip
// rates do not increase, a number is not above zero, or there are not as many of both.
friction::TableView steadyFriction(ParameterList const& list);
} // namespace asperity::scenario
