#pragma once

#include "base/Types.hpp"
#include "fem/bulk/Material.hpp"
#include "fem/bulk/MaxwellBranch.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "mesh/Mesh.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <array>
#include <optional>
#include <vector>

namespace asperity::scenario
{
// The rock of a body, from fields evaluated at the centroids of cells.
struct Rock
{
  std::vector<fem::Material> materials; // (num_cells)
  std::vector<fem::MaxwellBranch> branches;
  std::optional<fem::YieldingRock> yielding; // on all ranks or on none
};

// list: the deck's list `Bulk`, whose settings are `bulk`. Throws InputError unless all
// cells together have few relaxation times. Collective.
template <int Dim>
Rock makeRock(BulkSettings const& bulk, ParameterList const& list, Mesh<Dim> const& mesh,
              Communicator const& communicator);

// Density and elastic moduli of the rock at places in cells of the mesh (num_places).
template <int Dim>
std::vector<fem::Material> elasticRockAt(BulkSettings const& bulk, ParameterList const& list,
                                         Mesh<Dim> const& mesh, std::vector<int> const& cells,
                                         std::vector<std::array<double, 3>> const& places);
} // namespace asperity::scenario
