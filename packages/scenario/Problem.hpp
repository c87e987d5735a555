#pragma once

#include "base/Warning.hpp"
#include "dynamics/coupling/RateSolver.hpp"
#include "dynamics/initial/Model.hpp"
#include "fem/VolumetricPatches.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/constraints/Constraints.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/Upright.hpp"
#include "scenario/setup/conditions/BoundarySetup.hpp"
#include "scenario/setup/friction/FaultScales.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The discretised model of a deck, with the mesh and the conditions that it was made from.
template <int Dim>
struct Problem : dynamics::Model
{
  RCP<const Communicator> communicator;
  int components; // of the displacement
  BoundaryConditions<Dim> boundary;
  Mesh<Dim> mesh;
  std::shared_ptr<const fem::Constraints<Dim>> constraints;
  std::shared_ptr<const fem::FaultSurface> surface;
  std::vector<fem::Material> materials;       // (num_cells)
  std::vector<fem::MaxwellBranch> branches;   // of the rock
  fem::VolumetricPatches patches;             // of cells that share a volumetric strain
  std::vector<fem::Material> fault_materials; // (num fault nodes) of the body beside the fault
  dynamics::RateSolverSettings solver;
  std::vector<std::string> remarks; // for the user, in the log
  std::vector<Warning> warnings;    // found while the problem was made
  double largest_slip_rate;         // [m/s] dynamics::largestSlipRate
  FaultScales scales;
  Upright upright;
  // Also where the normal stress does not follow the body; empty where nothing presses across the
  // fault: antiplane, or beside a mirror image.
  dynamics::ReactionSinceStart across;
};

// `deck` must be complete. Collective.
template <int Dim>
Problem<Dim> makeProblem(ParameterList const& deck, RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
