#pragma once

#include "io/FieldRegistry.hpp"
#include "scenario/fields/Domains.hpp"
#include "scenario/fields/RunView.hpp"
#include "scenario/problem/Problem.hpp"

#include <string>

namespace asperity::scenario
{
// Registers what flow and inelastic strain have moved (dynamics::LockedResponse), in the volume and
// on the surface of a body that has them; with the lifetimes of registerFields.
template <int Dim>
void registerLockedResponse(io::FieldRegistry& registry, Problem<Dim> const& problem,
                            RunView const& view, Domains const& domains);
} // namespace asperity::scenario
