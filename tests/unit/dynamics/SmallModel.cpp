#include "unit/dynamics/SmallModel.hpp"

#include "dynamics/processes/RegularisedStress.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "fem/motions/RigidBodyMotions.hpp"
#include "fem/stress/CellStress.hpp"
#include "mesh/parallel/Partition.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"

#include <cmath>

namespace asperity::dynamics::test
{
namespace
{
friction::ParameterView table(std::vector<double> const& column, int num_nodes)
{
  Kokkos::View<double**, MemorySpace> values("asperity::test::parameters", column.size(),
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
std::vector<fem::VelocityCondition<Dim>> conditionsOf(OptionsIn<Dim> const& options)
{
  auto conditions = options.conditions;
  if (options.other_side.may_open) {
    conditions.insert(conditions.begin(),
                      {"Fault", options.fault, fem::FreeAcrossFault{{options.fault}}});
  } else if (options.components == Dim) {
    conditions.insert(conditions.begin(), {"Fault", options.fault, fem::SlidingWall{}});
  }
  return conditions;
}

template <int Dim>
std::vector<fem::MaxwellBranch> branchesOf(OptionsIn<Dim> const& options, std::size_t num_cells)
{
  std::vector<fem::MaxwellBranch> branches;
  for (auto const& [share, time] : options.relaxation) {
    branches.push_back(
      {time, std::vector<double>(num_cells, share * options.material.shear_modulus)});
  }
  return branches;
}

template <int Dim>
std::shared_ptr<const fem::InelasticCells>
cellsOf(OptionsIn<Dim> const& options, Mesh<Dim> const& mesh,
        std::shared_ptr<const fem::DofMap> const& dofs, fem::NodalFrames const& frames)
{
  if (options.yield.empty()) {
    return nullptr;
  }
  const std::size_t size = fem::tensorComponents(options.components).size();
  auto const stress =
    options.initial_stress.empty() ? std::vector<double>(size, 0.) : options.initial_stress;
  fem::YieldingRock rock;
  rock.parts.push_back({fem::bulkLaws().at(options.yield), {}, {}});
  auto values = options.strength;
  auto material = options.material;
  rock.parts.front().law.complete(values.data(), material);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    auto& part = rock.parts.front();
    part.cells.push_back(static_cast<int>(cell));
    part.parameters.insert(part.parameters.end(), values.begin(), values.end());
    rock.initial_stress.insert(rock.initial_stress.end(), stress.begin(), stress.end());
    rock.initial_mean.push_back(0);
  }
  return std::make_shared<fem::InelasticCells>(
    mesh, dofs, frames, std::vector<fem::Material>(mesh.cells.size(), options.material), rock);
}
} // namespace

template <int Dim>
ModelIn<Dim>::ModelIn(OptionsIn<Dim> const& given, RCP<const Communicator> const& communicator)
    : options(given)
    , mesh(mesh::distribute(given.mesh, *communicator))
    , dofs(std::make_shared<fem::DofMap>(mesh.global_ids, mesh.num_owned, options.components,
                                         communicator))
    , constraints(std::make_shared<fem::Constraints<Dim>>(mesh, *dofs, conditionsOf(options),
                                                          std::vector<double>{0}))
    , matrices(
        fem::assembleBody<Dim>(mesh, *dofs, constraints->frames(),
                               std::vector<fem::Material>(mesh.cells.size(), options.material),
                               branchesOf(options, mesh.cells.size())))
    , surface(fem::makeFaultSurface(mesh, options.fault, *constraints, *dofs,
                                    *matrices.stiffness->getCrsGraph(), options.other_side))
    , body(makeBody())
    , fault(makeFault())
{
}

template <int Dim>
Body ModelIn<Dim>::makeBody() const
{
  auto const load = makeLoad();
  auto const conditions = constraints;
  return {dofs,
          matrices,
          constraints->held(),
          fem::rigidBodyMotions(mesh, *dofs, constraints->frames()),
          [load](double, Vector& l) { Tpetra::deep_copy(l, *load); },
          [conditions](double t, Vector& v) { conditions->prescribedVelocity(t, v); },
          cellsOf(options, mesh, dofs, constraints->frames())};
}

template <int Dim>
Fault ModelIn<Dim>::makeFault() const
{
  const int size = surface->numNodes();
  auto const& o = options;
  auto const normal_stress =
    o.normal_stress ? NormalStress([this](double t, NodeView const& view) {
      Kokkos::deep_copy(view,
                        nodeView([&](Point<Dim> const& x) { return options.normal_stress(x, t); }));
    })
                    : NormalStress(nodeView([&](auto const&) { return options.sigma_n; }));
  std::shared_ptr<const FaultProcess> regularisation;
  if (o.regularisation) {
    const auto [slip, time] = *o.regularisation;
    regularisation = makeRegularisedStress(
      *surface, {std::vector<double>(size, slip), std::vector<double>(size, time)}, {});
  }
  return {surface,
          {o.law,
           table({o.a, o.b, o.reference_rate, o.reference_friction}, size),
           nodeView([&](auto const&) { return options.cohesion; }),
           o.state_law,
           table({o.L, o.reference_rate, 0.}, size),
           {},
           o.stress_sensitivity == 0 ? ConstNodeView()
                                     : nodeView([&](auto const&) { return o.stress_sensitivity; }),
           o.processes ? o.processes(*surface) : FaultProcesses(),
           {},
           regularisation},
          normal_stress};
}

template <int Dim>
RCP<const Vector> ModelIn<Dim>::makeLoad() const
{
  const std::vector<fem::Material> materials(mesh.cells.size(), options.material);
  auto const load =
    fem::assembleGravity<Dim>(mesh, *dofs, constraints->frames(), materials, options.gravity);
  auto const values = load->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int i = 0; i < surface->numNodes(); ++i) {
    auto const& node = (*surface)[i];
    values(node.dofs[0], 0) += options.traction * node.weight;
    Point<3> local{};
    constraints->frames().toFrame(surface->vertex(i), options.traction_along_axes.data(),
                                  local.data());
    for (int dof : node.dofs) {
      values(dof, 0) += local[dof % options.components] * node.weight;
    }
  }
  return load;
}

template <int Dim>
State ModelIn<Dim>::restingState() const
{
  State state;
  state.u = body.vector();
  state.v = body.vector();
  state.a = body.vector();
  state.jerk = body.vector();
  state.branches = body.noForces().branch_forces;
  if (body.cells) {
    state.inelastic = body.cells->none();
  }
  body.prescribed_velocity(0, *state.v);
  state.alpha = nodeView([](auto const&) { return 0.; });
  state.alpha_of_rate = nodeView([](auto const&) { return 0.; });
  state.alpha_defect = nodeView([](auto const&) { return 0.; });
  state.sigma_n = nodeView([](auto const&) { return 0.; });
  fault.normalStress().at(0, state.sigma_n);
  for (auto const& process : fault.processes()) {
    auto const fields = process->fields(state);
    state.added.insert(state.added.end(), fields.begin(), fields.end());
  }
  return state;
}

template <int Dim>
NodeView ModelIn<Dim>::nodeView(std::function<double(Point<Dim> const&)> const& value) const
{
  NodeView view("asperity::test::nodes", surface->numNodes());
  auto const host = Kokkos::create_mirror_view(view);
  for (int i = 0; i < surface->numNodes(); ++i) {
    host(i) = value(mesh.vertices[surface->vertex(i)]);
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
      if (!body.held[dof]) {
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
  settings.multigrid = *tnnmg::MultigridCorrection::validParameters();
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

Eigen::VectorXd denseOf(ConstNodeView const& x)
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
} // namespace asperity::dynamics::test
