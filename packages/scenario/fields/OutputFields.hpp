#pragma once

#include "io/FieldRegistry.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/fields/RunView.hpp"

namespace asperity::scenario
{
// Registers all fields and scalars that outputs may write. Problem, view and domains must outlive
// the registry.
template <int Dim>
void registerFields(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    Domains const& domains, ParameterList const& deck);
} // namespace asperity::scenario
