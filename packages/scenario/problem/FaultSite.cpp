#include "scenario/problem/FaultSite.hpp"

#include "fem/BoundaryCells.hpp"
#include "scenario/setup/FaultNodes.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

namespace asperity::scenario
{
namespace
{
template <int Dim>
std::shared_ptr<const fem::FaultSurface> makeSurface(Discretisation<Dim> const& discretisation,
                                                     CrsGraph const& graph)
{
  auto const& boundary = discretisation.boundary;
  auto const& mesh = discretisation.mesh;
  auto const surface =
    fem::makeFaultSurface(mesh, discretisation.fault_boundary, *discretisation.constraints,
                          *discretisation.dofs, graph, boundary.other_side, boundary.given_slip);
  return boundary.plate_rates.empty()
           ? surface
           : surface->withPlateRate(
               nodalPlateRates(boundary.plate_rates, mesh, *surface, discretisation.frames()));
}
} // namespace

template <int Dim>
FaultSite makeFaultSite(DeckSettings const& settings, Discretisation<Dim> const& discretisation,
                        CrsGraph const& graph)
{
  auto const& mesh = discretisation.mesh;
  auto surface = makeSurface(discretisation, graph);
  auto nodes = faultNodes(mesh, *surface, discretisation.boundary.faults);
  auto materials = fem::materialsAtNodes(mesh, *surface, discretisation.rock.materials);
  auto eta =
    radiationDamping(settings.bulk, settings.lists.bulk, nodes, surface->otherSide(), materials);
  return {std::move(surface), std::move(nodes), std::move(materials), std::move(eta)};
}

template FaultSite makeFaultSite(DeckSettings const&, Discretisation<2> const&, CrsGraph const&);
template FaultSite makeFaultSite(DeckSettings const&, Discretisation<3> const&, CrsGraph const&);
} // namespace asperity::scenario
