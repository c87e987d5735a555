#pragma once

#include "io/OutputDomain.hpp"
#include "scenario/problem/Problem.hpp"

#include <map>
#include <string>

namespace asperity::scenario
{
using Domains = std::map<std::string, io::OutputDomain>;

// The domains of the outputs by name: fault, volume and, if the deck has one, the free surface.
// Collective.
template <int Dim>
Domains makeDomains(Problem<Dim> const& problem);
} // namespace asperity::scenario
