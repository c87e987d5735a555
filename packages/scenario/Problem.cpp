#include "scenario/Problem.hpp"

#include "dynamics/InitialState.hpp"
#include "fem/BodyMatrices.hpp"
#include "fem/BoundaryCells.hpp"
#include "fem/NodalDamping.hpp"
#include "scenario/SupportWeights.hpp"
#include "scenario/setup/BoundaryChecks.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/FaultLoads.hpp"
#include "scenario/setup/FrictionSetup.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <sstream>

namespace asperity::scenario
{
namespace
{
// Calls work with the number of components as a constant.
template <int Dim, class Work>
auto withComponents(int components, Work const& work)
{
  if constexpr (Dim == 2) {
    if (components == 1) {
      return work(std::integral_constant<int, 1>());
    }
  }
  return work(std::integral_constant<int, Dim>());
}
} // namespace

template <int Dim>
Problem<Dim>::Problem(ParameterList const& deck, RCP<const Communicator> const& comm)
    : communicator(comm)
    , components(displacementComponents(deck.sublist("Bulk"), Dim))
    , boundary(makeBoundaryConditions<Dim>(deck.sublist("Boundary Conditions"), components))
    , mesh(makeMesh<Dim>(deck.sublist("Mesh"), boundary.fault, comm))
{
  requireBoundaries(deck.sublist("Boundary Conditions"), mesh);
  const double end = finalTime(deck.sublist("Time Stepping"));
  body.dofs = std::make_shared<fem::DofMap>(mesh.global_ids, mesh.num_owned, components, comm);
  fault_nodes = fem::boundaryNodes(mesh, boundary.fault, *comm);
  if (!boundary.surface.empty()) {
    fem::boundaryNodes(mesh, boundary.surface, *comm);
  }
  const std::vector<double> samples = {0, end / 3, end};
  constraints =
    std::make_unique<fem::Constraints<Dim>>(mesh, *body.dofs, boundary.velocities, samples);
  solver = makeSolverSettings(deck.sublist("TNNMG"), comm->getSize(), Dim,
                              mesh.num_global_vertices * components);
  auto const materials = makeMaterials(deck.sublist("Bulk"), mesh);
  makeBody(deck.sublist("Bulk"), materials);
  makeFault(deck, materials);
  for (double t : samples) {
    auto const prescribed = body.vector();
    body.prescribed_velocity(t, *prescribed);
    fault.requireWalls(*prescribed, components, t);
  }
  makeLoads(deck, materials);
  makeInitialState(deck);
}

template <int Dim>
void Problem<Dim>::makeBody(ParameterList const& bulk, std::vector<fem::Material> const& materials)
{
  auto const& frames = constraints->frames();
  body.matrices = withComponents<Dim>(components, [&](auto count) {
    return fem::assembleBody<Dim, count.value>(mesh, *body.dofs, frames, materials);
  });
  for (auto const& name : boundary.absorbing) {
    ASPERITY_REQUIRE(!quasiDynamic(bulk),
                     "Asperity / Boundary Conditions: the boundary '"
                       << name
                       << "' is Absorbing, but a quasi-dynamic body has no waves. Choose another "
                          "Type, or Bulk / Dynamics = Inertial.");
    fem::boundaryNodes(mesh, name, *communicator); // refuses one without facets
    auto const dampers = withComponents<Dim>(components, [&, &name = name](auto count) {
      return fem::absorbingBoundary<Dim, count.value>(mesh, name, frames, materials);
    });
    body.matrices.viscosity = fem::withDampers(*body.matrices.viscosity, *body.dofs, dampers);
  }
  if (quasiDynamic(bulk)) {
    body.matrices.mass = fem::zeroLike(*body.matrices.mass);
  }
  body.fixed = constraints->fixed();
  body.near_null_space = fem::rigidBodyMotions(mesh, *body.dofs, frames);
  body.prescribed_velocity = [this](double t, Vector& v) { constraints->prescribedVelocity(t, v); };
}

template <int Dim>
void Problem<Dim>::makeFault(ParameterList const& deck, std::vector<fem::Material> const& materials)
{
  auto const& bulk = deck.sublist("Bulk");
  fault = scenario::makeFault(deck.sublist("Friction"), mesh, fault_nodes, *body.dofs, *constraints,
                              boundary.slipFactor());
  fault_materials = fem::materialsAtNodes(mesh, boundary.fault, fault_nodes, materials);
  radiation_damping =
    radiationDamping(bulk, mesh, fault_nodes.nodes, fault_materials, fault.slip_factor);
  if (!quasiDynamic(bulk)) {
    return;
  }
  // The traction eta V = eta slip_factor v_t, lumped like friction.
  fem::NodalDampers dampers;
  for (int i = 0; i < fault.numNodes(); ++i) {
    const int node = fault_nodes.nodes[i];
    dampers[node] = {};
    for (int dof : fault.dofs[i]) {
      const int row = dof - body.dofs->dof(node, 0);
      dampers[node][row * components + row] =
        fault_nodes.weights[i] * radiation_damping[i] * fault.slip_factor;
    }
  }
  body.matrices.viscosity = fem::withDampers(*body.matrices.viscosity, *body.dofs, dampers);
}

template <int Dim>
void Problem<Dim>::makeLoads(ParameterList const& deck, std::vector<fem::Material> const& materials)
{
  auto const g = gravity<Dim>(deck.sublist("Bulk"));
  auto const& frames = constraints->frames();
  gravity_load_ = components == Dim
                    ? fem::assembleGravity<Dim, Dim>(mesh, *body.dofs, frames, materials, g)
                    : body.vector();
  body.load = loadWithTraction(ShearTraction(deck.sublist("Friction"), mesh, fault_nodes, frames),
                               fault_nodes.weights, fault, gravity_load_);
}

// Pressure of the foundation on the fault nodes: the reaction K u - l across the fault per weight
// of what bears it.
template <int Dim>
std::vector<double> Problem<Dim>::reactionPressure(Vector const& u) const
{
  Vector reaction(*gravity_load_, Teuchos::Copy);
  body.matrices.stiffness->apply(u, reaction, Teuchos::NO_TRANS, 1, -1);
  std::vector<double> along_axes;
  alongAxes(reaction, along_axes);
  std::vector<bool> slides;
  for (int i = 0; i < fault.numNodes(); ++i) {
    slides.push_back(fault.slides(i));
  }
  auto const weights =
    supportWeights(mesh, fault_nodes, boundary.velocities, boundary.fault, slides);
  std::vector<double> pressure;
  for (std::size_t i = 0; i < fault_nodes.nodes.size(); ++i) {
    const int node = fault_nodes.nodes[i];
    auto const& normal = fault_nodes.normals[i];
    double outward = 0;
    for (int d = 0; d < Dim; ++d) {
      outward += along_axes[Dim * node + d] * normal[d];
    }
    pressure.push_back(-outward / weights[i]);
  }
  return pressure;
}

// The displacement to start from, and the normal stress of the deck or of the static solution.
template <int Dim>
void Problem<Dim>::makeNormalStress(ParameterList const& friction, bool start_static)
{
  const bool stress_given = isGiven(friction, "Normal Stress");
  ASPERITY_REQUIRE(stress_given || components == Dim,
                   "Asperity / Friction / Normal Stress is missing: an antiplane model has no "
                   "normal stress of its own.");
  ASPERITY_REQUIRE(stress_given || !boundary.antisymmetric,
                   "Asperity / Friction / Normal Stress is missing: on an antisymmetric fault it "
                   "is that of the undisturbed state, which only the deck knows.");
  initial.u = body.vector();
  NormalStress stress;
  if (gravity_load_->normInf() > 0 && (start_static || !stress_given)) {
    auto const u = dynamics::staticDisplacement(body, solver, *gravity_load_);
    if (!stress_given) {
      stress.values = reactionPressure(*u);
    }
    if (start_static) {
      initial.u = u;
    }
  } else {
    ASPERITY_REQUIRE(stress_given,
                     "Asperity / Friction / Normal Stress is missing, and without gravity there is "
                     "no normal stress either. Give one of the two.");
  }
  setNormalStress(fault, friction, mesh, fault_nodes.nodes, stress);
  if (stress.num_tensile > 0) {
    std::ostringstream remark;
    remark << "The static solution pulls at " << stress.num_tensile
           << " fault nodes; their normal stress is set to zero.";
    remarks.push_back(remark.str());
  }
}

// The deck's traction is all there is: a static displacement leaves none, since it has slid without
// friction, and neither does none at all.
template <int Dim>
InitialFault Problem<Dim>::startOfFault(ParameterList const& friction) const
{
  InitialFault result;
  result.traction = ShearTraction(friction, mesh, fault_nodes, constraints->frames()).at(0);
  result.radiation = radiation_damping;
  auto const velocities = initial.v->getLocalViewHost(Tpetra::Access::ReadOnly);
  for (auto const& dofs : fault.dofs) {
    for (int dof : dofs) {
      result.velocity.push_back(velocities(dof, 0));
    }
  }
  return result;
}

// By a difference over a time dt [s] in which nothing else happens.
template <int Dim>
RCP<Vector> Problem<Dim>::prescribedAcceleration(double dt) const
{
  auto result = body.vector();
  auto const at_zero = body.vector();
  body.prescribed_velocity(dt, *result);
  body.prescribed_velocity(0, *at_zero);
  result->update(-1 / dt, *at_zero, 1 / dt);
  return result;
}

template <int Dim>
void Problem<Dim>::makeInitialState(ParameterList const& deck)
{
  auto const& list = deck.sublist("Initial State");
  auto const& friction = deck.sublist("Friction");
  makeNormalStress(friction, list.get<std::string>("Displacement") == "Static");
  initial.v = initialVelocity(list, mesh, body, *constraints);
  initial.alpha = initialAlpha(list, mesh, fault_nodes.nodes, fault, startOfFault(friction));
  initial.alpha_of_rate = friction::NodeView("asperity::scenario::alphaOfRate", fault.numNodes());
  Kokkos::deep_copy(initial.alpha_of_rate, initial.alpha);
  initial.a = body.vector();
  if (list.get<std::string>("Acceleration") == "Balanced" && !quasiDynamic(deck.sublist("Bulk"))) {
    const double dt = makeClock(deck.sublist("Time Stepping")).stepSize(0) * 1e-6;
    auto const load = body.vector();
    body.load(0, *load);
    initial.a = dynamics::initialAcceleration(body, fault, solver, friction.get<std::string>("Law"),
                                              *load, *prescribedAcceleration(dt), *initial.u,
                                              *initial.v, initial.alpha);
  }
  initial.jerk = body.vector();
}

template <int Dim>
void Problem<Dim>::alongAxes(Vector const& x, std::vector<double>& result) const
{
  auto const values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  result.resize(static_cast<std::size_t>(mesh.num_owned) * components);
  for (int node = 0; node < mesh.num_owned; ++node) {
    std::array<double, 3> local{};
    for (int c = 0; c < components; ++c) {
      local[c] = values(body.dofs->dof(node, c), 0);
    }
    constraints->frames().fromFrame(node, local.data(),
                                    &result[static_cast<std::size_t>(node) * components]);
  }
}

template struct Problem<2>;
template struct Problem<3>;
} // namespace asperity::scenario
