#pragma once

#include "base/Warning.hpp"
#include "dynamics/initial/Model.hpp"
#include "dynamics/rate/RateSolver.hpp"
#include "fem/bulk/Material.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/problem/DeckSettings.hpp"
#include "scenario/problem/Discretisation.hpp"
#include "scenario/problem/FaultScales.hpp"
#include "scenario/problem/Findings.hpp"
#include "scenario/setup/friction/LawsAtNodes.hpp"

#include <vector>

namespace asperity::scenario
{
// The discretised model of a deck.
template <int Dim>
struct Problem
{
  RCP<const Communicator> communicator;
  DeckSettings settings;
  Discretisation<Dim> discretisation;
  dynamics::RateSolverSettings solver;
  dynamics::Model model;
  LawsAtNodes laws;                           // of the fault
  std::vector<fem::Material> fault_materials; // (num fault nodes) of the body beside the fault
  FaultScales scales;
  Findings findings;
  // Also where the normal stress does not follow the body; empty where nothing presses across the
  // fault: antiplane, or beside a mirror image.
  dynamics::ReactionSinceStart across;

  Mesh<Dim> const& mesh() const { return discretisation.mesh; }
  int components() const { return discretisation.components(); }
  fem::FaultSurface const& surface() const { return model.fault.surface(); }
};

// `deck` must be complete. Collective.
template <int Dim>
Problem<Dim> makeProblem(ParameterList const& deck, RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
