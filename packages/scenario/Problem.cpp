#include "scenario/Problem.hpp"

#include "base/Text.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/checks/MaterialContrast.hpp"
#include "dynamics/checks/PlausibleValues.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "dynamics/initial/FoundationPressure.hpp"
#include "dynamics/initial/StaticSolver.hpp"
#include "fem/BodyPieces.hpp"
#include "fem/BoundaryCells.hpp"
#include "fem/BoundaryMeasure.hpp"
#include "fem/FaultMesh.hpp"
#include "fem/FreeMotions.hpp"
#include "fem/NodalDamping.hpp"
#include "fem/PatchedBody.hpp"
#include "fem/RigidBodyMotions.hpp"
#include "fem/Simplex.hpp"
#include "fem/SupportWeights.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/PointText.hpp"
#include "parameters/ParameterValue.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/FaultNodes.hpp"
#include "scenario/setup/InitialSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "scenario/setup/VolumetricSetup.hpp"
#include "scenario/setup/conditions/BoundaryChecks.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"
#include "scenario/setup/conditions/FreeFault.hpp"
#include "scenario/setup/friction/FaultLoads.hpp"
#include "scenario/setup/friction/FrictionSetup.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <limits>

namespace asperity::scenario
{
namespace
{
// The mesh with its unknowns, constraints and rock.
template <int Dim>
struct Discretisation
{
  BoundaryConditions<Dim> boundary;
  Mesh<Dim> mesh;
  std::shared_ptr<const fem::DofMap> dofs;
  std::shared_ptr<const fem::Constraints<Dim>> constraints;
  Rock rock;
  fem::VolumetricPatches patches;
  std::vector<double> samples; // times at which conditions are compared [s]
  Upright upright;

  fem::NodalFrames const& frames() const { return constraints->frames(); }
};

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

template <int Dim>
Discretisation<Dim> discretise(ParameterList const& deck,
                               RCP<const Communicator> const& communicator)
{
  auto const& conditions = deck.sublist("Boundary Conditions");
  const int components = displacementComponents(deck.sublist("Bulk"), Dim);
  auto boundary = makeBoundaryConditions<Dim>(conditions, components);
  ASPERITY_REQUIRE(!boundary.faults.empty() || !hasGivenEntry(deck.sublist("Friction")),
                   "Asperity / Friction has no effect: Asperity / Boundary Conditions has no "
                   "condition of Type "
                     << quotedAlternatives(faultKinds())
                     << " or 'Prescribed Slip Rate'. Name the boundary that is the fault, or "
                        "remove the list.");
  auto mesh = makeMesh<Dim>(deck.sublist("Mesh"),
                            boundary.faults.empty() ? "" : boundary.faults.front(), communicator);
  requireGlobalIds(mesh, components);
  requireBoundaries(conditions, mesh);
  requireFaults(conditions, mesh, *communicator);
  requireFreeFault(boundary, mesh, components, *communicator);
  if (!boundary.surface.empty()) {
    fem::boundaryMeasure(mesh, boundary.surface, *communicator); // refuses one without facets
  }
  auto const& bulk = deck.sublist("Bulk");
  auto rock = makeRock(bulk, mesh, *communicator);
  auto patches = makePatches(bulk, boundary.faults, mesh, rock, *communicator);
  auto const dofs =
    std::make_shared<fem::DofMap>(mesh.global_ids, mesh.num_owned, components, communicator);
  const double end = finalTime(deck.sublist("Time Stepping"));
  const std::vector<double> samples = {0, end / 3, end};
  auto const constraints =
    std::make_shared<fem::Constraints<Dim>>(mesh, *dofs, boundary.velocities, samples);
  auto upright = uprightOf(
    deck, Dim,
    {boundary.free_surfaces, fem::integrateNormal(mesh, boundary.free_surfaces, *communicator)});
  return {std::move(boundary), std::move(mesh),    dofs,    constraints,
          std::move(rock),     std::move(patches), samples, std::move(upright)};
}

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

// Without inertia every rigid motion of the body needs something that stops or resists it: a
// condition, or friction and radiation damping along the fault that is given, unless it is null.
// `why` says what does not exist otherwise, `cure` what else helps.
template <int Dim>
void requireNoFreeMotion(Discretisation<Dim> const& of, dynamics::Body const& body,
                         fem::FaultSurface const* resisting_fault, std::string const& why,
                         std::string const& cure = "")
{
  std::vector<int> resisting(body.numOwnedDofs(), 0);
  for (const int dof : body.held.owned()) {
    resisting[dof] = 1;
  }
  if (resisting_fault != nullptr) {
    for (auto const& node : *resisting_fault) {
      for (const int dof : node.dofs) {
        resisting[dof] = 1;
      }
    }
  }
  auto const free = fem::freeMotions(of.mesh, of.dofs->components(), *body.near_null_space,
                                     resisting, of.dofs->communicator());
  ASPERITY_REQUIRE(
    free.empty(), "Asperity / Boundary Conditions: nothing stops or resists the body when it moves "
                    << free.front() << ", and " << why
                    << " does not exist or is not unique. Add a condition on a boundary that "
                       "stops this motion: Fixed, Sliding Wall, or Prescribed Velocity in that "
                       "direction, with a Velocity of 0 if it is to rest"
                    << cure << ".");
}

// The displacement at the start, and the pressure of the foundation in it.
struct StaticStart
{
  RCP<Vector> displacement;
  // (num fault nodes) [Pa]; zero if the deck gives it, or friction does not ask for it
  std::vector<double> pressure;
};

template <int Dim>
StaticStart staticStart(ParameterList const& deck, Discretisation<Dim> const& of,
                        dynamics::Body const& body, dynamics::RateSolverSettings const& solver,
                        fem::FaultSurface const& surface, Vector const& load)
{
  auto const& friction = deck.sublist("Friction");
  // Where friction does not ask for the normal stress, it need not follow from the static solution.
  const bool stress_given =
    isGiven(friction, "Normal Stress") || !bearsFriction(friction) || surface.numGlobalNodes() == 0;
  ASPERITY_REQUIRE(stress_given || of.dofs->components() == Dim,
                   "Asperity / Friction / Normal Stress is missing: an antiplane model has no "
                   "normal stress of its own. Give it.");
  ASPERITY_REQUIRE(stress_given || !surface.otherSide().is_mirrored,
                   "Asperity / Friction / Normal Stress is missing: on an antisymmetric fault it "
                   "does not follow from the static solution. Give that of the undisturbed state.");
  const bool follows = followsAtOnce(friction); // Prakash-Clifton also follows pressure and time
  ASPERITY_REQUIRE(!follows || of.dofs->components() == Dim,
                   "Asperity / Friction / Normal Stress Change = "
                     << friction.get<std::string>("Normal Stress Change")
                     << ", but antiplane motion does not press across the fault. Choose Fixed.");
  ASPERITY_REQUIRE(!follows || !surface.otherSide().is_mirrored,
                   "Asperity / Friction / Normal Stress Change = "
                     << friction.get<std::string>("Normal Stress Change")
                     << ", but by symmetry the normal stress of an Antisymmetric Fault does not "
                        "change. Choose Fixed.");
  const bool start_static = startsStatic(deck.sublist("Initial State"));
  const bool has_load = load.normInf() > 0;
  ASPERITY_REQUIRE(stress_given || has_load,
                   "Asperity / Friction / Normal Stress is missing, and without gravity or a "
                   "Prescribed Traction it cannot follow from the static solution. Give one of "
                   "them.");
  StaticStart start{body.vector(), std::vector<double>(surface.numNodes(), 0.)};
  if (!has_load || (stress_given && !start_static)) {
    return start;
  }
  requireNoFreeMotion(of, body, nullptr,
                      "its static displacement, for which the fault slides without friction,",
                      stress_given ? "; or choose Initial State / Displacement = Zero, if the load "
                                     "is to set the body in motion"
                                   : "");
  auto const u = dynamics::StaticSolver(body, solver).solve(load);
  if (!stress_given) {
    auto const support = fem::supportWeights(of.mesh, surface, of.boundary.velocities);
    start.pressure = dynamics::foundationPressure(body, of.frames(), surface, support, load, *u);
  }
  if (start_static) {
    start.displacement = u;
  }
  return start;
}

// Throws InputError if rock yields under its stress at the start.
template <int Dim>
void requireBearable(Discretisation<Dim> const& of, dynamics::Body const& body, Vector const& u)
{
  if (!body.cells) {
    return;
  }
  auto const beyond = body.cells->furthestBeyond(u);
  onEveryRank(*of.dofs->communicator(), [&] {
    ASPERITY_REQUIRE(!beyond,
                     "Asperity / Bulk: at the start the rock at "
                       << mesh::text(fem::simplexOf(of.mesh, beyond->cell).centroid)
                       << " bears a shear stress of " << beyond->shear_stress
                       << " Pa, but it yields at " << beyond->kept
                       << " Pa (sqrt(s : s / 2) of the deviatoric stress s). Check the strength of "
                          "the rock, Initial Stress and gravity.");
  });
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
  warnings.insert(warnings.end(), stress.warnings.begin(), stress.warnings.end());
  if (auto const warning = warnOfContrast(deck, of.mesh, *surface)) {
    warnings.push_back(*warning);
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
          {dynamics::describeSpeeds(beside)},
          std::move(warnings),
          dynamics::largestSlipRate(beside),
          std::move(scales),
          std::move(of.upright),
          across};
}

template Problem<2> makeProblem(ParameterList const&, RCP<const Communicator> const&);
template Problem<3> makeProblem(ParameterList const&, RCP<const Communicator> const&);
} // namespace asperity::scenario
