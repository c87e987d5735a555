#pragma once

#include "scenario/problem/Problem.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// A line that says where up is, where it matters; for each fault a line that says where its plus
// side is and what slip is positive, in space with its strike, its dip and the rake of a positive
// shear traction or of prescribed slip, and one for the plates' motion along it, if the deck has
// one. Collective.
template <int Dim>
std::vector<std::string> describeSense(Problem<Dim> const& problem);

// Whether positive slip has the same sense on all faults, as files for SEAS and SCEC take it.
// Collective.
template <int Dim>
bool haveOneSense(Problem<Dim> const& problem);
} // namespace asperity::scenario
