#include "scenario/problem/Discretisation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "mesh/Boundaries.hpp"
#include "parameters/ParameterValue.hpp"
#include "scenario/problem/OpeningRequirements.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/conditions/BoundaryChecks.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"
#include "scenario/setup/conditions/FreeFault.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "scenario/setup/rock/VolumetricSetup.hpp"

#include <limits>
#include <set>
#include <utility>

namespace asperity::scenario
{
namespace
{
// Throws on all ranks or on none.
template <int Dim>
void requireGlobalIds(Mesh<Dim> const& mesh, int components)
{
  constexpr auto most = std::numeric_limits<GlobalOrdinal>::max();
  ASPERITY_REQUIRE(mesh.num_global_vertices < most / components,
                   "The mesh has " << mesh.num_global_vertices << " vertices with " << components
                                   << " unknowns each, more than the " << most
                                   << " that Trilinos, as it was built, can number. Take a coarser "
                                      "mesh, or a Trilinos with global ids of type long long.");
}

// The boundaries that no condition holds or damps: those without one, and those under a traction.
template <int Dim>
OuterSurface openBoundaries(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh,
                            Communicator const& communicator)
{
  std::set<std::string> not_open(mesh.faults.begin(), mesh.faults.end());
  for (auto const& condition : conditions) {
    if (!condition.type->is_open) {
      not_open.insert(condition.boundary);
    }
  }
  std::vector<std::string> open;
  for (auto const& entry : mesh.boundaries) {
    if (not_open.count(entry.first) == 0) {
      open.push_back(entry.first);
    }
  }
  return {open, fem::integrateNormal(mesh, open, communicator)};
}
} // namespace

template <int Dim>
Discretisation<Dim> discretise(DeckSettings const& settings,
                               RCP<const Communicator> const& communicator)
{
  auto const& conditions = settings.conditions;
  requireDimension(settings.bulk, Dim);
  const int components = settings.bulk.components;
  auto boundary = makeBoundaryConditions<Dim>(conditions, components);
  auto kinds = faultKinds();
  kinds.push_back(continuationType().name);
  ASPERITY_REQUIRE(!boundary.faults.empty() || !hasGivenEntry(settings.lists.friction),
                   "Asperity / Friction has no effect: Asperity / Boundary Conditions has no "
                   "condition of Type "
                     << quotedAlternatives(kinds)
                     << ". Name the boundary that is the fault, or remove the list.");
  const auto branch_end = components == 2 ? mesh::BranchEnd::tip : mesh::BranchEnd::joint;
  auto mesh = makeMesh<Dim>(settings.mesh, boundary.faults.empty() ? "" : boundary.faults.front(),
                            branch_end, communicator);
  requireGlobalIds(mesh, components);
  requireBoundaries(conditions, mesh);
  requireFaults(conditions, mesh, *communicator);
  requireOwnFacets(conditions, mesh, *communicator);
  requirePlaneOfMirror(conditions, mesh, *communicator);
  requireFreeFault(boundary, mesh, components, *communicator);
  requireNoJunction(boundary, mesh, *communicator);
  if (!boundary.surface.empty()) {
    fem::boundaryMeasure(mesh, boundary.surface, *communicator); // refuses one without facets
  }
  auto const& bulk = settings.lists.bulk;
  auto rock = makeRock(settings.bulk, bulk, mesh, *communicator);
  auto patches = makePatches(settings.bulk, bulk, boundary.faults, mesh, rock, *communicator);
  auto upright = uprightOf(
    settings.bulk, settings.up, Dim,
    {boundary.free_surfaces, fem::integrateNormal(mesh, boundary.free_surfaces, *communicator)},
    openBoundaries(conditions, mesh, *communicator));
  auto fault_boundary = mesh::joinBoundaries(mesh, boundary.faults); // the mesh is complete
  auto const dofs =
    std::make_shared<fem::DofMap>(mesh.global_ids, mesh.num_owned, components, communicator);
  const double end = settings.time.final_time;
  const std::vector<double> samples = {0, end / 3, end};
  auto const constraints =
    std::make_shared<fem::Constraints<Dim>>(mesh, *dofs, boundary.velocities, samples);
  return {std::move(boundary), std::move(mesh), std::move(fault_boundary), dofs,
          constraints,         std::move(rock), std::move(patches),        samples,
          std::move(upright)};
}

template Discretisation<2> discretise(DeckSettings const&, RCP<const Communicator> const&);
template Discretisation<3> discretise(DeckSettings const&, RCP<const Communicator> const&);
} // namespace asperity::scenario
