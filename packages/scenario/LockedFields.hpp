#pragma once

#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"
#include "scenario/RunView.hpp"
#include "scenario/problem/Problem.hpp"

#include <map>
#include <string>

namespace asperity::scenario
{
// Registers what flow and inelastic strain have moved (dynamics::LockedResponse), in the volume and
// on the surface of a body that has them; with the lifetimes of registerFields.
template <int Dim>
void registerLockedResponse(io::FieldRegistry& registry, Problem<Dim> const& problem,
                            RunView const& view,
                            std::map<std::string, io::OutputDomain> const& domains);
} // namespace asperity::scenario
