#include "scenario/Problem.hpp"

#include "dynamics/InitialState.hpp"
#include "fem/BodyMatrices.hpp"
#include "scenario/BulkSetup.hpp"
#include "scenario/FrictionSetup.hpp"
#include "scenario/MeshSetup.hpp"
#include "scenario/NodalField.hpp"
#include "scenario/SolverSetup.hpp"
#include "scenario/TimeSetup.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <numeric>
#include <sstream>

namespace asperity::scenario
{
namespace
{
const std::string initial_path = "Asperity / Initial State";
constexpr std::array<char const*, 3> velocity_names = {"Velocity X", "Velocity Y", "Velocity Z"};

// Translations and the rotation (antiplane: the one translation), in nodal frames.
RCP<MultiVector> rigidBodyMotions(Mesh<2> const& mesh, fem::DofMap const& dofs,
                                  fem::NodalFrames const& frames)
{
  const int components = dofs.components();
  auto motions = rcp(new MultiVector(dofs.owned(), components == 1 ? 1 : 3));
  auto values = motions->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (int node = 0; node < dofs.numOwnedNodes(); ++node) {
    if (components == 1) {
      values(dofs.dof(node, 0), 0) = 1;
      continue;
    }
    auto const& x = mesh.vertices[node];
    const std::array<std::array<double, 2>, 3> along_axes = {{{1, 0}, {0, 1}, {-x[1], x[0]}}};
    for (int motion = 0; motion < 3; ++motion) {
      std::array<double, 2> local{};
      frames.toFrame(node, along_axes[motion].data(), local.data());
      for (int c = 0; c < 2; ++c) {
        values(dofs.dof(node, c), motion) = local[c];
      }
    }
  }
  return motions;
}
} // namespace

RCP<const ParameterList> initialStateParameters()
{
  return Declare()
    .choice("Displacement", "Static", {"Static", "Zero"},
            "Static: the displacement under gravity with a frictionless fault. Zero: none.")
    .field(velocity_names[0], 0., "m/s", Range::any(), "Initial velocity along x (plane strain).")
    .field(velocity_names[1], 0., "m/s", Range::any(), "Initial velocity along y (plane strain).")
    .field(velocity_names[2], 0., "m/s", Range::any(), "Initial velocity along z (antiplane).")
    .choice("Acceleration", "Balanced", {"Balanced", "Zero"},
            "Balanced: from the balance of momentum. Zero: none, whatever the forces.")
    .field("alpha", 0., "-", Range::any(),
           "Initial state ln(theta V* / L); 0 is steady sliding at V*.")
    .list();
}

Problem::Problem(ParameterList const& deck, RCP<const Communicator> const& comm)
    : communicator(comm)
    , mesh(makeMesh(deck.sublist("Mesh"), comm))
    , components(displacementComponents(deck.sublist("Bulk")))
    , boundary(makeBoundaryConditions(deck.sublist("Boundary Conditions"), components))
{
  const double end = finalTime(deck.sublist("Time Stepping"));
  body.dofs = std::make_shared<fem::DofMap>(mesh.global_ids, mesh.num_owned, components, comm);
  fault_nodes = fem::boundaryNodes(mesh, boundary.fault, *comm);
  if (!boundary.surface.empty()) {
    fem::boundaryNodes(mesh, boundary.surface, *comm);
  }
  constraints = std::make_unique<fem::Constraints<2>>(mesh, *body.dofs, boundary.velocities,
                                                      std::vector<double>{0, end / 3, end});
  solver = makeSolverSettings(deck.sublist("TNNMG"), comm->getSize(),
                              mesh.num_global_vertices * components);
  auto const materials = makeMaterials(deck.sublist("Bulk"), mesh);
  if (components == 2) {
    body.matrices = fem::assembleBody<2, 2>(mesh, *body.dofs, constraints->frames(), materials);
  } else {
    body.matrices = fem::assembleBody<2, 1>(mesh, *body.dofs, constraints->frames(), materials);
  }
  body.fixed = constraints->fixed();
  body.near_null_space = rigidBodyMotions(mesh, *body.dofs, constraints->frames());
  body.prescribed_velocity = [this](double t, Vector& v) { constraints->prescribedVelocity(t, v); };
  fault =
    scenario::makeFault(deck.sublist("Friction"), mesh, fault_nodes, *body.dofs, *constraints);
  makeLoads(deck, materials);
  makeInitialState(deck);
}

void Problem::makeLoads(ParameterList const& deck, std::vector<fem::Material> const& materials)
{
  auto const g = gravity(deck.sublist("Bulk"));
  if (components == 2) {
    gravity_load_ =
      fem::assembleGravity<2, 2>(mesh, *body.dofs, constraints->frames(), materials, g);
  } else {
    gravity_load_ = body.vector();
  }
  load_ = rcp(new Vector(*gravity_load_, Teuchos::Copy));
  auto const traction = nodalValues(deck.sublist("Friction"), "Shear Traction",
                                    "Asperity / Friction", mesh, fault_nodes.nodes);
  auto const values = load_->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int i = 0; i < fault.numNodes(); ++i) {
    values(fault.dofs[i][0], 0) += fault_nodes.weights[i] * traction[i];
  }
  body.load = [load = load_](double, Vector& l) { Tpetra::deep_copy(l, *load); };
}

// Pressure of the foundation on the fault nodes: the reaction K u - l across the fault per weight.
std::vector<double> Problem::reactionPressure(Vector const& u) const
{
  Vector reaction(*gravity_load_, Teuchos::Copy);
  body.matrices.stiffness->apply(u, reaction, Teuchos::NO_TRANS, 1, -1);
  std::vector<double> along_axes;
  alongAxes(reaction, along_axes);
  std::vector<double> pressure;
  for (std::size_t i = 0; i < fault_nodes.nodes.size(); ++i) {
    const int node = fault_nodes.nodes[i];
    auto const& normal = fault_nodes.normals[i];
    const double inward =
      -(along_axes[2 * node] * normal[0] + along_axes[2 * node + 1] * normal[1]);
    pressure.push_back(inward / fault_nodes.weights[i]);
  }
  return pressure;
}

RCP<Vector> Problem::initialVelocity(ParameterList const& list) const
{
  auto v = body.vector();
  body.prescribed_velocity(0, *v);
  std::vector<int> nodes(mesh.num_owned);
  std::iota(nodes.begin(), nodes.end(), 0);
  std::vector<std::vector<double>> along(components);
  for (int c = 0; c < components; ++c) {
    along[c] =
      nodalValues(list, velocity_names[components == 1 ? 2 : c], initial_path, mesh, nodes);
  }
  auto const values = v->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < mesh.num_owned; ++node) {
    std::array<double, 3> along_axes{};
    std::array<double, 3> local{};
    for (int c = 0; c < components; ++c) {
      along_axes[c] = along[c][node];
    }
    constraints->frames().toFrame(node, along_axes.data(), local.data());
    for (int c = 0; c < components; ++c) {
      const int dof = body.dofs->dof(node, c);
      if (!body.fixed[dof]) {
        values(dof, 0) = local[c];
      }
    }
  }
  return v;
}

void Problem::makeInitialState(ParameterList const& deck)
{
  auto const& list = deck.sublist("Initial State");
  auto const& friction = deck.sublist("Friction");
  const bool stress_given = isGiven(friction, "Normal Stress");
  const bool start_static = list.get<std::string>("Displacement") == "Static";
  ASPERITY_REQUIRE(stress_given || components == 2,
                   "Asperity / Friction / Normal Stress is missing: an antiplane model has no "
                   "normal stress of its "
                   "own.");
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

  initial.v = initialVelocity(list);
  initial.alpha = valuesAtNodes(list, "alpha", initial_path, mesh, fault_nodes.nodes);
  initial.alpha_of_rate = friction::NodeView("asperity::scenario::alphaOfRate", fault.numNodes());
  Kokkos::deep_copy(initial.alpha_of_rate, initial.alpha);
  initial.a = body.vector();
  if (list.get<std::string>("Acceleration") == "Balanced") {
    // The prescribed acceleration, by a difference over a time in which nothing else happens.
    const double dt = makeClock(deck.sublist("Time Stepping")).stepSize(0) * 1e-6;
    auto prescribed = body.vector();
    auto at_zero = body.vector();
    body.prescribed_velocity(dt, *prescribed);
    body.prescribed_velocity(0, *at_zero);
    prescribed->update(-1 / dt, *at_zero, 1 / dt);
    initial.a =
      dynamics::initialAcceleration(body, fault, solver, friction.get<std::string>("Law"), *load_,
                                    *prescribed, *initial.u, *initial.v, initial.alpha);
  }
}

void Problem::alongAxes(Vector const& x, std::vector<double>& result) const
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
} // namespace asperity::scenario
