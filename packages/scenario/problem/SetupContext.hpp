#pragma once

#include "dynamics/rate/RateSolver.hpp"
#include "scenario/problem/DeckSettings.hpp"
#include "scenario/problem/Discretisation.hpp"
#include "scenario/problem/FaultSite.hpp"

namespace asperity::scenario
{
// What the later stages of a problem need: what the deck says and the results of the first stages.
template <int Dim>
struct SetupContext
{
  DeckSettings const& settings;
  Discretisation<Dim> const& discretisation;
  dynamics::RateSolverSettings const& solver;
  FaultSite const& site;

  Communicator const& communicator() const { return *discretisation.dofs->communicator(); }
  int components() const { return discretisation.components(); }
  // Whether motion of the body presses across the fault: neither in antiplane motion nor beside a
  // mirror image.
  bool bodyPresses() const { return components() == Dim && !site.surface->otherSide().is_mirrored; }
};
} // namespace asperity::scenario
