#pragma once

#include "io/FieldRegistry.hpp"
#include "scenario/fields/RunView.hpp"
#include "scenario/problem/Problem.hpp"

namespace asperity::scenario
{
// Registers the fields on the fault: those of the state and of processes, and constant ones.
// Problem and view must outlive the registry.
template <int Dim>
void registerFaultFields(io::FieldRegistry& registry, Problem<Dim> const& problem,
                         RunView const& view);
} // namespace asperity::scenario
