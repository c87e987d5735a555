#pragma once

#include "io/FieldRegistry.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/fields/RunView.hpp"
#include "scenario/problem/Problem.hpp"

#include <string>

namespace asperity::scenario
{
// Registers the displacement that viscous flow and inelastic strain have caused
// (dynamics::LockedResponse), in the volume and on the surface of a body that has them. Problem,
// view and domains must outlive the registry.
template <int Dim>
void registerLockedResponse(io::FieldRegistry& registry, Problem<Dim> const& problem,
                            RunView const& view, Domains const& domains);
} // namespace asperity::scenario
