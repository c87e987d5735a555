#pragma once

#include "base/Types.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/bulk/Material.hpp"
#include "scenario/problem/DeckSettings.hpp"
#include "scenario/problem/Discretisation.hpp"
#include "scenario/setup/NodalField.hpp"

#include <memory>
#include <vector>

namespace asperity::scenario
{
// Where the fault lies, and the rock beside it.
struct FaultSite
{
  std::shared_ptr<const fem::FaultSurface> surface; // with the motion of the plates
  FieldNodes nodes;                                 // of the surface
  std::vector<fem::Material> materials;             // (num_nodes) of the body beside the fault
  std::vector<double> radiation_damping;            // eta(num_nodes) [Pa s/m] per slip rate
};

// graph: of the body's matrices, by which nodes of the fault are coloured. The discretisation has
// to outlive the result. InputError on all ranks where the deck's fault has no sense. Collective.
template <int Dim>
FaultSite makeFaultSite(DeckSettings const& settings, Discretisation<Dim> const& discretisation,
                        CrsGraph const& graph);
} // namespace asperity::scenario
