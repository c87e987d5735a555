#pragma once

#include "fem/VolumetricPatches.hpp"
#include "fem/constraints/Constraints.hpp"
#include "fem/dofs/DofMap.hpp"
#include "mesh/Mesh.hpp"
#include "scenario/problem/DeckSettings.hpp"
#include "scenario/problem/Upright.hpp"
#include "scenario/setup/conditions/BoundarySetup.hpp"
#include "scenario/setup/rock/RockSetup.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::scenario
{
// The mesh with its unknowns, constraints and rock.
template <int Dim>
struct Discretisation
{
  BoundaryConditions<Dim> boundary;
  Mesh<Dim> mesh;
  std::string fault_boundary; // of the mesh: that of all faults, or none
  std::shared_ptr<const fem::DofMap> dofs;
  std::shared_ptr<const fem::Constraints<Dim>> constraints;
  Rock rock;
  fem::VolumetricPatches patches;
  std::vector<double> samples; // times at which conditions are compared [s]
  Upright upright;

  fem::NodalFrames const& frames() const { return constraints->frames(); }
  int components() const { return dofs->components(); } // of the displacement
};

// Makes or reads the mesh, and makes what follows from it. Throws InputError on all ranks where
// mesh, boundary conditions and rock contradict each other. Collective.
template <int Dim>
Discretisation<Dim> discretise(DeckSettings const& settings,
                               RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
