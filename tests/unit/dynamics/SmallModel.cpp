#include "unit/dynamics/SmallModel.hpp"

#include "fem/RigidBodyMotions.hpp"
#include "friction/Registry.hpp"
#include "mesh/parallel/Partition.hpp"
#include "tnnmg/MueLuCorrection.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <cmath>

namespace asperity::dynamics::testing
{
namespace
{
friction::ParameterView table(std::vector<double> const& column, int num_nodes)
{
  Kokkos::View<double**, friction::MemorySpace> values("asperity::test::parameters", column.size(),
                                                       num_nodes);
  auto const host = Kokkos::create_mirror_view(values);
  for (std::size_t row = 0; row < column.size(); ++row) {
    for (int node = 0; node < num_nodes; ++node) {
      host(row, node) = column[row];
    }
  }
  Kokkos::deep_copy(values, host);
  return values;
}

template <int Dim>
fem::BodyMatrices assemble(Mesh<Dim> const& mesh, fem::DofMap const& dofs,
                           fem::NodalFrames const& frames, fem::Material const& material)
{
  const std::vector<fem::Material> materials(mesh.cells.size(), material);
  if constexpr (Dim == 2) {
    if (dofs.components() == 1) {
      return fem::assembleBody<2, 1>(mesh, dofs, frames, materials);
    }
  }
  return fem::assembleBody<Dim, Dim>(mesh, dofs, frames, materials);
}
} // namespace

template <int Dim>
ModelIn<Dim>::ModelIn(OptionsIn<Dim> const& given, RCP<const Communicator> const& communicator)
    : options(given)
    , mesh(mesh::distribute(given.mesh, *communicator))
    , fault_nodes(fem::boundaryNodes(mesh, given.fault, *communicator))
{
  auto conditions = options.conditions;
  if (options.components == Dim) {
    conditions.insert(conditions.begin(), {"Fault", options.fault, fem::SlidingWall{}});
  }
  body.dofs = std::make_shared<fem::DofMap>(mesh.global_ids, mesh.num_owned, options.components,
                                            communicator);
  constraints =
    std::make_unique<fem::Constraints<Dim>>(mesh, *body.dofs, conditions, std::vector<double>{0});
  auto const& frames = constraints->frames();
  body.matrices = assemble(mesh, *body.dofs, frames, options.material);
  body.fixed = constraints->fixed();
  body.prescribed_velocity = [this](double t, Vector& v) { constraints->prescribedVelocity(t, v); };
  body.near_null_space = fem::rigidBodyMotions(mesh, *body.dofs, frames);
  makeFault();
  makeLoad();
}

template <int Dim>
void ModelIn<Dim>::makeFault()
{
  auto const& communicator = body.dofs->communicator();
  const int size = static_cast<int>(fault_nodes.nodes.size());
  double mine = 0;
  for (int i = 0; i < size; ++i) {
    const int node = fault_nodes.nodes[i];
    fault.dofs.emplace_back();
    fault.fixed.emplace_back();
    for (int component :
         fem::tangentialComponents(constraints->frames(), node, fault_nodes.normals[i])) {
      const int dof = body.dofs->dof(node, component);
      fault.dofs.back().push_back(dof);
      fault.fixed.back().push_back(body.fixed[dof] ? 1 : 0);
    }
    mine += fault_nodes.weights[i];
  }
  fault.num_tangents = Dim - 1;
  fault.communicator = communicator;
  fault.slip_factor = options.slip_factor;
  Teuchos::reduceAll(*communicator, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(fault.total_weight));

  friction::NodeView weight("asperity::test::weight", size);
  friction::NodeView factor("asperity::test::slipFactor", size);
  Kokkos::deep_copy(factor, options.slip_factor);
  auto const host = Kokkos::create_mirror_view(weight);
  std::copy(fault_nodes.weights.begin(), fault_nodes.weights.end(), host.data());
  Kokkos::deep_copy(weight, host);
  fault.data.weight = weight;
  fault.data.slip_factor = factor;
  fault.normal_stress = nodeView([&](auto const&) { return options.sigma_n; });
  fault.data.sigma_n = fault.normal_stress;
  if (options.normal_stress) {
    fault.normal_stress_at = [this](double t, friction::NodeView const& view) {
      Kokkos::deep_copy(view,
                        nodeView([&](Point<Dim> const& x) { return options.normal_stress(x, t); }));
    };
    fault.setTime(0);
  }
  fault.data.cohesion = nodeView([&](auto const&) { return options.cohesion; });
  fault.data.parameters =
    table({options.a, options.b, options.reference_rate, options.reference_friction}, size);
  fault.friction = friction::makeFrictionKernels(options.law, fault.data);
  fault.state =
    friction::makeStateKernels(options.state_law, table({options.L, options.reference_rate}, size));
}

template <int Dim>
void ModelIn<Dim>::makeLoad()
{
  auto load = body.vector();
  if (options.components == Dim) {
    const std::vector<fem::Material> materials(mesh.cells.size(), options.material);
    load = fem::assembleGravity<Dim, Dim>(mesh, *body.dofs, constraints->frames(), materials,
                                          options.gravity);
  }
  {
    auto const values = load->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int i = 0; i < fault.numNodes(); ++i) {
      values(fault.dofs[i][0], 0) += options.traction * fault_nodes.weights[i];
      Point<3> local{};
      constraints->frames().toFrame(fault_nodes.nodes[i], options.traction_along_axes.data(),
                                    local.data());
      for (int dof : fault.dofs[i]) {
        values(dof, 0) += local[dof % options.components] * fault_nodes.weights[i];
      }
    }
  }
  body.load = [load](double, Vector& l) { Tpetra::deep_copy(l, *load); };
}

template <int Dim>
State ModelIn<Dim>::restingState() const
{
  State state;
  state.u = body.vector();
  state.v = body.vector();
  state.a = body.vector();
  state.jerk = body.vector();
  body.prescribed_velocity(0, *state.v);
  state.alpha = nodeView([](auto const&) { return 0.; });
  state.alpha_of_rate = nodeView([](auto const&) { return 0.; });
  return state;
}

template <int Dim>
friction::NodeView
ModelIn<Dim>::nodeView(std::function<double(Point<Dim> const&)> const& value) const
{
  friction::NodeView view("asperity::test::nodes", fault_nodes.nodes.size());
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < fault_nodes.nodes.size(); ++i) {
    host(i) = value(mesh.vertices[fault_nodes.nodes[i]]);
  }
  Kokkos::deep_copy(view, host);
  return view;
}

template <int Dim>
double ModelIn<Dim>::normalStress(int node, double t) const
{
  return options.normal_stress ? options.normal_stress(mesh.vertices[node], t) : options.sigma_n;
}

template <int Dim>
void ModelIn<Dim>::setFree(Vector& x,
                           std::function<Point<Dim>(Point<Dim> const&)> const& value) const
{
  auto const values = x.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < mesh.num_owned; ++node) {
    auto const along_axes = value(mesh.vertices[node]);
    Point<Dim> local{};
    constraints->frames().toFrame(node, along_axes.data(), local.data());
    for (int c = 0; c < options.components; ++c) {
      const int dof = body.dofs->dof(node, c);
      if (!body.fixed[dof]) {
        values(dof, 0) = local[c];
      }
    }
  }
}

template <int Dim>
Point<Dim> ModelIn<Dim>::valueAt(Vector const& x, int node) const
{
  auto const values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  Point<Dim> along_axes{};
  constraints->frames().fromFrame(node, &values(body.dofs->dof(node, 0), 0), along_axes.data());
  return along_axes;
}

template struct ModelIn<2>;
template struct ModelIn<3>;

RateSolverSettings tightSettings(Correction correction)
{
  RateSolverSettings settings;
  settings.tnnmg.absolute_tolerance = 1e-13;
  settings.tnnmg.relative_tolerance = 1e-13;
  settings.tnnmg.correction_tolerance = 1e-6;
  settings.correction = correction;
  settings.multigrid = *tnnmg::MueLuCorrection::validParameters();
  return settings;
}

CouplingSettings tightCoupling()
{
  CouplingSettings settings;
  settings.tolerance = 1e-13;
  settings.max_iterations = 200;
  return settings;
}

Eigen::VectorXd denseOf(Vector const& x)
{
  auto const values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  return Eigen::Map<const Eigen::VectorXd>(&values(0, 0), values.extent(0));
}

Eigen::VectorXd denseOf(friction::ConstNodeView const& x)
{
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), x);
  return Eigen::Map<const Eigen::VectorXd>(host.data(), host.extent(0));
}

Eigen::MatrixXd denseOf(CrsMatrix const& matrix)
{
  auto const local = matrix.getLocalMatrixHost();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(local.numRows(), local.numCols());
  for (int row = 0; row < local.numRows(); ++row) {
    for (auto e = local.graph.row_map(row); e < local.graph.row_map(row + 1); ++e) {
      result(row, local.graph.entries(e)) += local.values(e);
    }
  }
  return result;
}
} // namespace asperity::dynamics::testing
