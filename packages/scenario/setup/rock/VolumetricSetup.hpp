#pragma once

#include "base/Warning.hpp"
#include "fem/VolumetricPatches.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/setup/rock/RockSetup.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The patches of cells that share a volumetric strain; none in an antiplane model, and where no
// cell needs one. Several ranks then get the missing cells of their patches: mesh and rock become
// larger. list: the deck's list `Bulk`. faults: names of boundaries. Collective.
template <int Dim>
fem::VolumetricPatches makePatches(BulkSettings const& bulk, ParameterList const& list,
                                   std::vector<std::string> const& faults, Mesh<Dim>& mesh,
                                   Rock& rock, Communicator const& communicator);

// A warning about nearly incompressible cells that take their mean stress from their own volumetric
// strain, and are therefore too stiff; empty if there are none. Collective.
std::vector<Warning> warnOfLocking(BulkSettings const& bulk, Rock const& rock,
                                   Communicator const& communicator);
} // namespace asperity::scenario
