#pragma once

#include "dynamics/coupling/RateSolver.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/problem/Discretisation.hpp"
#include "scenario/problem/FaultSite.hpp"

namespace asperity::scenario
{
// What the later stages of a problem need: the deck and the results of the first stages.
template <int Dim>
struct SetupContext
{
  ParameterList const& deck;
  Discretisation<Dim> const& discretisation;
  dynamics::RateSolverSettings const& solver;
  FaultSite const& site;

  Communicator const& communicator() const { return *discretisation.dofs->communicator(); }
  int components() const { return discretisation.components(); }
};
} // namespace asperity::scenario
