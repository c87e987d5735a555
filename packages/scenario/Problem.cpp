#include "scenario/Problem.hpp"

#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/checks/MaterialContrast.hpp"
#include "dynamics/checks/PlausibleValues.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "dynamics/initial/FoundationPressure.hpp"
#include "dynamics/initial/StaticSolver.hpp"
#include "fem/BoundaryCells.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "fem/FaultMesh.hpp"
#include "fem/NodalDamping.hpp"
#include "fem/PatchedBody.hpp"
#include "fem/Simplex.hpp"
#include "fem/SupportWeights.hpp"
#include "fem/motions/BodyPieces.hpp"
#include "fem/motions/FreeMotions.hpp"
#include "fem/motions/RigidBodyMotions.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/PointText.hpp"
#include "parameters/ParameterValue.hpp"
#include "scenario/Discretisation.hpp"
#include "scenario/StaticStart.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/FaultNodes.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/StressAtStart.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/VolumetricSetup.hpp"
#include "scenario/setup/conditions/BoundaryChecks.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"
#include "scenario/setup/conditions/FreeFault.hpp"
#include "scenario/setup/friction/FaultLoads.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/friction/LawSetup.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <limits>

namespace asperity::scenario
{
namespace
{
// The viscosity of the body with its absorbing boundaries and the radiation damping of its fault,
// eta(num fault nodes) [Pa s/m] per slip rate.
template <int Dim>
RCP<const CrsMatrix> dampedViscosity(Discretisation<Dim> const& of, RCP<const CrsMatrix> viscosity,
                                     ParameterList const& bulk, fem::FaultSurface const& surface,
                                     std::vector<double> const& eta)
{
  for (auto const& name : of.boundary.absorbing) {
    ASPERITY_REQUIRE(!quasiDynamic(bulk),
                     "Asperity / Boundary Conditions: the boundary '"
                       << name
                       << "' is Absorbing, but a quasi-dynamic body has no waves. Choose another "
                          "Type, or Bulk / Dynamics = Inertial.");
    fem::boundaryMeasure(of.mesh, name, *of.dofs->communicator()); // refuses one without facets
    viscosity =
      fem::withDampers(*viscosity, *of.dofs,
                       fem::absorbingBoundary<Dim>(of.mesh, name, of.frames(), of.rock.materials));
  }
  return quasiDynamic(bulk)
           ? fem::withDampers(*viscosity, *of.dofs, fem::radiationDampers(surface, *of.dofs, eta))
           : viscosity;
}

// Radiation damping acts on the whole slip rate; the dampers of dampedViscosity act only on the
// part that is the motion of the body, so that the part of the plates becomes a load.
RCP<const Vector> withRadiationOfPlates(RCP<const Vector> const& load,
                                        fem::FaultSurface const& surface,
                                        std::vector<double> const& eta)
{
  if (!surface.hasPlateRate()) {
    return load;
  }
  auto const result = rcp(new Vector(*load, Teuchos::Copy));
  fem::addRadiationOfPlates(surface, eta, *result);
  return result;
}

dynamics::Extremes extremesOf(std::vector<double> const& values, Communicator const& communicator)
{
  dynamics::Extremes mine{std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
  for (const double value : values) {
    mine = {std::min(mine.smallest, value), std::max(mine.largest, value)};
  }
  return {minOverRanks(mine.smallest, communicator), maxOverRanks(mine.largest, communicator)};
}

dynamics::BesideFault valuesBeside(std::vector<fem::Material> const& materials,
                                   std::vector<double> const& eta, dynamics::State const& initial,
                                   int components, Communicator const& communicator)
{
  const auto extremes = [&](auto const& value) {
    std::vector<double> values;
    for (auto const& material : materials) {
      values.push_back(value(material));
    }
    return extremesOf(values, communicator);
  };
  using fem::Material;
  auto const sigma_n = toHost(initial.sigma_n);
  return {extremes([](Material const& m) { return m.density; }),
          extremes([](Material const& m) { return m.shear_modulus; }),
          extremes([](Material const& m) { return m.shearImpedance() / m.density; }),
          extremes([](Material const& m) { return m.compressionalImpedance() / m.density; }),
          extremesOf(eta, communicator),
          extremesOf({sigma_n.data(), sigma_n.data() + sigma_n.extent(0)}, communicator),
          components == 1};
}

// A warning where unlike rocks, inertia, and friction that follows the normal stress at once meet.
template <int Dim>
std::optional<Warning> warnOfContrast(ParameterList const& deck, Mesh<Dim> const& mesh,
                                      fem::FaultSurface const& surface)
{
  auto const& bulk = deck.sublist("Bulk");
  auto const& friction = deck.sublist("Friction");
  if (!surface.otherSide().is_inside || quasiDynamic(bulk) || !followsAtOnce(friction)) {
    return std::nullopt;
  }
  auto const plus = dynamics::placesBeside(mesh, surface, fem::Side::plus);
  auto const minus = dynamics::placesBeside(mesh, surface, fem::Side::minus);
  std::vector<fem::Material> above, below;
  onEveryRank(*surface.communicator(), [&] {
    above = elasticRockAt(bulk, mesh, plus.cells, plus.places);
    below = elasticRockAt(bulk, mesh, minus.cells, minus.places);
  });
  return dynamics::warnOfContrast(
    dynamics::materialContrast(plus.places, above, below, *surface.communicator()),
    friction.get<std::string>("Normal Stress Change"));
}

// Empty where nothing presses across the fault.
template <int Dim>
dynamics::ReactionSinceStart
reactionSinceStart(Discretisation<Dim> const& of, dynamics::Body const& body,
                   dynamics::Fault const& fault, dynamics::State const& initial)
{
  auto const& surface = fault.surface();
  if (of.dofs->components() < Dim || surface.otherSide().is_mirrored ||
      surface.numGlobalNodes() == 0) {
    return {};
  }
  return dynamics::reactionSince(
    initial.motion(), body,
    std::make_shared<dynamics::NormalReaction>(
      body, surface, of.frames(), fem::supportWeights(of.mesh, surface, of.boundary.velocities)));
}

// The surface of the fault under the motion of plates. Joins its boundaries in the mesh.
template <int Dim>
std::shared_ptr<const fem::FaultSurface> makeSurface(Discretisation<Dim>& of,
                                                     fem::BodyMatrices const& matrices)
{
  auto const name = mesh::joinBoundaries(of.mesh, of.boundary.faults);
  auto const surface = fem::makeFaultSurface(of.mesh, name, *of.constraints, *of.dofs,
                                             *matrices.stiffness->getCrsGraph(),
                                             of.boundary.other_side, of.boundary.given_slip);
  return of.boundary.plate_rates.empty()
           ? surface
           : surface->withPlateRate(
               nodalPlateRates(of.boundary.plate_rates, of.mesh, *surface, of.frames()));
}

// Throws InputError if its velocity does not exist.
template <int Dim>
dynamics::Body makeBody(Discretisation<Dim> const& of, fem::BodyMatrices const& matrices,
                        fem::FaultSurface const& surface,
                        std::function<void(double, Vector&)> const& load)
{
  auto const constraints = of.constraints;
  dynamics::Body body{
    of.dofs,
    matrices,
    constraints->held(),
    fem::rigidBodyMotions(of.mesh, *of.dofs, of.frames()),
    load,
    [constraints](double t, Vector& v) { constraints->prescribedVelocity(t, v); }};
  if (body.matrices.is_massless) {
    requireNoFreeMotion(of, body, &surface, "the velocity of a quasi-dynamic body");
  }
  return body;
}
} // namespace

template <int Dim>
Problem<Dim> makeProblem(ParameterList const& deck, RCP<const Communicator> const& communicator)
{
  auto const& bulk = deck.sublist("Bulk");
  auto const& friction = deck.sublist("Friction");
  auto of = discretise<Dim>(deck, communicator);
  const int components = of.dofs->components();
  auto const solver = makeSolverSettings(deck.sublist("TNNMG"), communicator->getSize(), Dim,
                                         of.mesh.num_global_vertices * components);

  auto matrices = fem::assemblePatchedBody<Dim>(of.mesh, *of.dofs, of.frames(), of.rock.materials,
                                                of.rock.branches, of.patches);
  auto const surface = makeSurface(of, matrices);
  auto const fault_materials = fem::materialsAtNodes(of.mesh, *surface, of.rock.materials);
  auto const nodes = faultNodes(of.mesh, *surface);
  auto const eta = radiationDamping(bulk, nodes, surface->otherSide(), fault_materials);
  matrices.viscosity =
    fem::withoutZeros(dampedViscosity(of, matrices.viscosity, bulk, *surface, eta));
  if (quasiDynamic(bulk)) {
    matrices.mass = fem::withoutZeros(fem::zeroLike(*matrices.mass));
    matrices.is_massless = true;
  }

  auto const gravity = fem::assembleGravity<Dim>(of.mesh, *of.dofs, of.frames(), of.rock.materials,
                                                 scenario::gravity<Dim>(bulk, of.upright.down));
  const ShearTraction traction(friction, nodes, *surface, of.frames());
  auto const on_boundaries =
    std::make_shared<fem::BoundaryLoad>(of.mesh, *of.dofs, of.frames(), of.boundary.tractions);
  auto body = makeBody(of, matrices, *surface,
                       loadWithTraction(traction, surface, on_boundaries,
                                        withRadiationOfPlates(gravity, *surface, eta)));
  if (of.rock.yielding) {
    body.cells = std::make_shared<fem::InelasticCells>(of.mesh, of.dofs, of.frames(),
                                                       of.rock.materials, *of.rock.yielding);
  }
  on_boundaries->addSteady(*gravity);
  on_boundaries->addVarying(0, *gravity);
  auto const start = staticStart(deck, of, body, solver, *surface, *gravity);
  auto const stress = makeNormalStress(friction, nodes, start.pressure, *surface);
  auto fault =
    makeFault(friction, nodes, surface, fem::makeFaultMesh(of.mesh, *surface), stress.normal_stress,
              components == Dim && !surface->otherSide().is_mirrored, eta);
  auto initial = makeInitialState(deck, of.mesh, of.frames(), body, fault, solver,
                                  {start.displacement, traction.at(0), traction.direction()});
  requireBearable(of, body, *initial.u);
  auto const across = reactionSinceStart(of, body, fault, initial);
  const bool follows = fault.normalStress().change() != dynamics::NormalStressChange::fixed;
  auto warnings = fem::warnOfPieces(of.mesh, communicator);
  auto const locking = warnOfLocking(bulk, of.rock, *communicator);
  warnings.insert(warnings.end(), locking.begin(), locking.end());
  const bool has_fault = surface->numGlobalNodes() > 0;
  auto beside = valuesBeside(has_fault ? fault_materials : of.rock.materials, eta, initial,
                             components, *communicator);
  beside.has_fault = has_fault;
  auto scales = fault.stateDecides()
                  ? faultScales(of.mesh, components, fault_materials, friction, nodes, fault,
                                initial, traction.largest(of.samples))
                  : FaultScales();
  auto const questions = dynamics::questionValues(beside);
  warnings.insert(warnings.end(), questions.begin(), questions.end());
  if (bearsFriction(friction)) {
    auto const of_friction = questionFriction(friction, nodes, *communicator);
    warnings.insert(warnings.end(), of_friction.begin(), of_friction.end());
  }
  warnings.insert(warnings.end(), stress.warnings.begin(), stress.warnings.end());
  // A static displacement has stress of its own.
  if (of.rock.yielding && !(start.displacement->normInf() > 0)) {
    if (auto const warning =
          warnOfStressAtStart(deck, of.mesh, *of.rock.yielding, nodes, *surface, traction.at(0))) {
      warnings.push_back(*warning);
    }
  }
  for (auto const& warning :
       {warnOfUp(bulk, Dim, of.upright), warnOfContrast(deck, of.mesh, *surface),
        warnOfVelocity(deck, of.mesh, *surface)}) {
    if (warning) {
      warnings.push_back(*warning);
    }
  }
  std::vector<std::string> remarks = {dynamics::describeSpeeds(beside)};
  for (auto const& process : fault.processes()) {
    auto const of_process = process->remarks();
    remarks.insert(remarks.end(), of_process.begin(), of_process.end());
  }
  return {{std::move(body), std::move(fault), std::move(initial),
           follows ? across : dynamics::ReactionSinceStart()},
          communicator,
          components,
          std::move(of.boundary),
          std::move(of.mesh),
          of.constraints,
          surface,
          std::move(of.rock.materials),
          std::move(of.rock.branches),
          std::move(of.patches),
          fault_materials,
          solver,
          std::move(remarks),
          std::move(warnings),
          dynamics::largestSlipRate(beside),
          std::move(scales),
          std::move(of.upright),
          across};
}

template Problem<2> makeProblem(ParameterList const&, RCP<const Communicator> const&);
template Problem<3> makeProblem(ParameterList const&, RCP<const Communicator> const&);
} // namespace asperity::scenario
