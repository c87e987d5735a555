#include "scenario/problem/LoadedBody.hpp"

#include "base/parallel/Agreement.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "fem/NodalDamping.hpp"
#include "fem/motions/RigidBodyMotions.hpp"
#include "scenario/problem/StartRequirements.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace asperity::scenario
{
namespace
{
// A matrix of the body with the dashpots or the springs of its boundaries. Collective.
template <int Dim>
RCP<const CrsMatrix> withResistances(SetupContext<Dim> const& context, RCP<const CrsMatrix> matrix,
                                     fem::BoundaryResistance::Against against)
{
  auto const& discretisation = context.discretisation;
  const bool is_massless = context.settings.bulk.isQuasiDynamic();
  for (auto const& resistance : discretisation.boundary.resistances) {
    if (resistance.against != against) {
      continue;
    }
    ASPERITY_REQUIRE(!resistance.absorbs_waves || !is_massless,
                     "Asperity / Boundary Conditions: the boundary '"
                       << resistance.boundary
                       << "' is Absorbing, but a quasi-dynamic body has no waves. Choose another "
                          "Type, or Bulk / Dynamics = Inertial.");
    auto const& mesh = discretisation.mesh;
    // Refuses one without facets.
    fem::boundaryMeasure(mesh, resistance.boundary, context.communicator());
    fem::NodalDampers blocks;
    onEveryRank(context.communicator(), [&] {
      blocks = fem::resistanceOf<Dim>(mesh, resistance, discretisation.frames(),
                                      discretisation.rock.materials);
    });
    matrix = fem::withDampers(*matrix, *discretisation.dofs, blocks);
  }
  return matrix;
}

// The viscosity of the body with the dashpots of its boundaries and the radiation damping of its
// fault.
template <int Dim>
RCP<const CrsMatrix> dampedViscosity(SetupContext<Dim> const& context,
                                     RCP<const CrsMatrix> const& undamped)
{
  auto const viscosity =
    withResistances(context, undamped, fem::BoundaryResistance::Against::velocity);
  auto const& site = context.site;
  auto const& dofs = *context.discretisation.dofs;
  return context.settings.bulk.isQuasiDynamic()
           ? fem::withDampers(*viscosity, dofs,
                              fem::radiationDampers(*site.surface, dofs, site.radiation_damping))
           : viscosity;
}

// Radiation damping acts on the whole slip rate; the dampers of dampedViscosity act only on the
// part that is the motion of the body, so that the part of the plates becomes a load.
RCP<const Vector> withRadiationOfPlates(RCP<const Vector> const& load, FaultSite const& site)
{
  if (!site.surface->hasPlateRate()) {
    return load;
  }
  auto const result = rcp(new Vector(*load, Teuchos::Copy));
  fem::addRadiationOfPlates(*site.surface, site.radiation_damping, *result);
  return result;
}
} // namespace

template <int Dim>
LoadedBody makeBody(SetupContext<Dim> const& context, fem::BodyMatrices matrices)
{
  auto const& discretisation = context.discretisation;
  auto const& mesh = discretisation.mesh;
  auto const& rock = discretisation.rock;
  auto const& dofs = *discretisation.dofs;
  auto const& frames = discretisation.frames();
  auto const& surface = context.site.surface;
  auto const& bulk = context.settings.bulk;
  matrices.stiffness =
    withResistances(context, matrices.stiffness, fem::BoundaryResistance::Against::displacement);
  matrices.viscosity = fem::withoutZeros(dampedViscosity(context, matrices.viscosity));
  if (bulk.isQuasiDynamic()) {
    matrices.mass = fem::withoutZeros(fem::zeroLike(*matrices.mass));
    matrices.is_massless = true;
  }

  auto const gravity = fem::assembleGravity<Dim>(
    mesh, dofs, frames, rock.materials, scenario::gravity<Dim>(bulk, discretisation.upright.down));
  ShearTraction traction(context.settings.friction, context.settings.lists.friction,
                         context.site.nodes, *surface, frames);
  auto const on_boundaries =
    std::make_shared<fem::BoundaryLoad>(mesh, dofs, frames, discretisation.boundary.tractions);
  auto const constraints = discretisation.constraints;
  dynamics::Body body{
    discretisation.dofs,
    std::move(matrices),
    constraints->held(),
    fem::rigidBodyMotions(mesh, dofs, frames),
    loadWithTraction(traction, surface, on_boundaries,
                     withRadiationOfPlates(gravity, context.site)),
    [constraints](double t, Vector& v) { constraints->prescribedVelocity(t, v); }};
  if (body.matrices.is_massless) {
    requireMasslessVelocity(discretisation, body, *surface);
  }
  if (rock.yielding) {
    body.cells = std::make_shared<fem::InelasticCells>(mesh, discretisation.dofs, frames,
                                                       rock.materials, *rock.yielding);
  }
  auto const static_load = rcp(new Vector(*gravity, Teuchos::Copy));
  on_boundaries->addSteady(*static_load);
  on_boundaries->addVarying(0, *static_load);
  return {std::move(body), std::move(traction), static_load};
}

template LoadedBody makeBody(SetupContext<2> const&, fem::BodyMatrices);
template LoadedBody makeBody(SetupContext<3> const&, fem::BodyMatrices);
} // namespace asperity::scenario
