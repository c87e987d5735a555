#include "dynamics/EnergyBalance.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/FaultMotion.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::dynamics
{
namespace
{
// This rank's part of the work of a force in a step: mean over the ends times displacement.
double work(Vector const& u0, Vector const& u1, Vector const& f0, Vector const& f1)
{
  const auto read = [](Vector const& x) { return x.getLocalViewDevice(Tpetra::Access::ReadOnly); };
  auto const from = read(u0), to = read(u1), before = read(f0), after = read(f1);
  double sum = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::work", Kokkos::RangePolicy<ExecutionSpace>(0, from.extent(0)),
    KOKKOS_LAMBDA(int dof, double& part) {
      part += (before(dof, 0) + after(dof, 0)) / 2 * (to(dof, 0) - from(dof, 0));
    },
    sum);
  return sum;
}
} // namespace

std::array<Energy::Member, 8> const& Energy::members()
{
  static constexpr std::array<Member, 8> all = {
    {{"kinetic", &Energy::kinetic},
     {"elastic", &Energy::elastic},
     {"load_work", &Energy::load_work},
     {"boundary_work", &Energy::boundary_work},
     {"friction_work", &Energy::friction_work},
     {"viscous_work", &Energy::viscous_work},
     {"numerical_dissipation", &Energy::numerical_dissipation},
     {"defect", &Energy::defect}}};
  return all;
}

EnergyBalance::EnergyBalance(Body const& body, Fault const& fault, DyadicTime const& clock)
    : body_(body)
    , fault_(fault)
    , clock_(clock)
    , before_(snapshot())
    , after_(snapshot())
    , momentum_(body.vector())
    , v_("asperity::dynamics::v", fault.surface().numNodes(), fault.surface().numTangents())
    , gradient_("asperity::dynamics::gradient", fault.surface().numNodes(),
                fault.surface().numTangents())
    , hessian_("asperity::dynamics::hessian", fault.surface().numNodes(),
               fault.surface().numTangents(), fault.surface().numTangents())
    , kinked_("asperity::dynamics::kinked", fault.surface().numNodes())
{
  for (auto const& node : fault.surface()) {
    for (int dof : node.dofs) {
      if (!body.held[dof]) {
        fault_dofs_.push_back(dof);
      }
    }
  }
}

EnergyBalance::Snapshot EnergyBalance::snapshot() const
{
  return {body_.vector(), body_.vector(), body_.vector(), body_.vector(), body_.noForces()};
}

void EnergyBalance::fill(State const& state, Snapshot& result)
{
  Tpetra::deep_copy(*result.u, *state.u);
  Tpetra::deep_copy(*result.v, *state.v);
  result.time = state.time;
  body_.load(clock_.seconds(state.time), *result.load);
  body_.computeForces(*state.u, *state.v, *state.a, result.resisting, momentum_.get());
  result.elastic = 0.5 * result.resisting.elastic->dot(*state.u);
  result.kinetic = 0.5 * momentum_->dot(*state.v);
  fillForce(state, result);
}

// Sets at.force: friction at the dofs of the fault (at nodes at rest the residual, which friction
// balances), and reactions at held dofs.
void EnergyBalance::fillForce(State const& state, Snapshot const& at)
{
  auto const& surface = fault_.surface();
  gatherSlip(surface, *state.v, v_);
  fault_.friction().linearise(v_, {state.alpha_of_rate, state.sigma_n}, gradient_, hessian_,
                              kinked_);
  auto const gradient = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gradient_);
  auto const v = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), v_);
  auto const load = at.load->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const elastic = at.resisting.elastic->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const viscous = at.resisting.viscous->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const inertial = at.resisting.inertial->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto residual = [&](int dof) {
    return load(dof, 0) - inertial(dof, 0) - viscous(dof, 0) - elastic(dof, 0);
  };
  at.force->putScalar(0);
  auto const force = at.force->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < surface.numNodes(); ++node) {
    bool sliding = false;
    for (int k = 0; k < surface.numTangents(); ++k) {
      sliding = sliding || v(node, k) != 0;
    }
    for (int k = 0; k < surface.numTangents(); ++k) {
      const int dof = surface[node].dofs[k];
      force(dof, 0) = sliding ? gradient(node, k) : residual(dof);
    }
  }
  for (int dof : body_.held.owned()) {
    force(dof, 0) = residual(dof);
  }
}

void EnergyBalance::start(State const& state)
{
  resume(state, {});
  if (body_.matrices.is_massless) {
    noteImbalance();
  }
}

void EnergyBalance::noteImbalance()
{
  start_residual_ = body_.vector();
  start_residual_->update(1, *before_.load, 0);
  before_.resisting.subtractFrom(*start_residual_);
  auto const driving = *start_residual_; // l - C v - K u
  start_residual_->update(-1, *before_.force, 1);
  body_.clearHeld(*start_residual_);

  auto const r0 = start_residual_->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const r = driving.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const f = before_.force->getLocalViewHost(Tpetra::Access::ReadOnly);
  std::array<double, 4> squares{}; // of r0 everywhere; r0, r and f on the fault
  for (int dof = 0; dof < body_.numOwnedDofs(); ++dof) {
    squares[0] += r0(dof, 0) * r0(dof, 0);
  }
  for (const int dof : fault_dofs_) {
    squares[1] += r0(dof, 0) * r0(dof, 0);
    squares[2] += r(dof, 0) * r(dof, 0);
    squares[3] += f(dof, 0) * f(dof, 0);
  }
  auto const all = sumOverRanks(squares, *body_.dofs->communicator());
  const auto ratio = [](double part, double whole) { return part > 0 ? part / whole : 0; };
  const double whole = std::max(before_.load->norm2(), before_.resisting.elastic->norm2());
  start_imbalance_ = std::max(std::sqrt(ratio(all[1], std::max(all[2], all[3]))),
                              std::sqrt(ratio(std::max(all[0] - all[1], 0.), whole * whole)));
}

void EnergyBalance::resume(State const& state, Energy const& so_far)
{
  start_residual_ = Teuchos::null;
  start_imbalance_ = 0;
  fill(state, before_);
  energy_ = so_far;
  energy_.kinetic = before_.kinetic;
  energy_.elastic = before_.elastic;
}

// Of this rank, in the step from before_ to after_.
EnergyBalance::Works EnergyBalance::worksOfStep() const
{
  Works works;
  works.load = work(*before_.u, *after_.u, *before_.load, *after_.load);
  works.viscous =
    work(*before_.u, *after_.u, *before_.resisting.viscous, *after_.resisting.viscous);
  works.inertial =
    work(*before_.u, *after_.u, *before_.resisting.inertial, *after_.resisting.inertial);
  auto const u0 = before_.u->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const u1 = after_.u->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const f0 = before_.force->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const f1 = after_.force->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto workAt = [&](std::vector<int> const& dofs) {
    double work = 0;
    for (int dof : dofs) {
      work += (f0(dof, 0) + f1(dof, 0)) / 2 * (u1(dof, 0) - u0(dof, 0));
    }
    return work;
  };
  works.friction = workAt(fault_dofs_);
  works.boundary = -workAt(body_.held.owned());
  return works;
}

// Of this rank, in the step from before_ to after_: what the motion of the plates adds to the works
// of friction and of radiation damping, and to that of the loads, which supply it. The part eta Vp
// of the traction of radiation damping is a load of the body (fem::addRadiationOfPlates): its work
// is moved from the loads to what damping dissipates.
EnergyBalance::Works EnergyBalance::workOfPlates() const
{
  Works works;
  auto const& surface = fault_.surface();
  if (!surface.hasPlateRate()) {
    return works;
  }
  const double tau = clock_.seconds(after_.time - before_.time);
  const double factor = surface.slipFactor();
  auto const& eta = fault_.laws().radiation_damping;
  auto const f0 = before_.force->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const f1 = after_.force->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const v0 = before_.v->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const v1 = after_.v->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const u0 = before_.u->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const u1 = after_.u->getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      const int dof = surface[node].dofs[k];
      const double Vp = surface.plateRate(node, k);
      const double by_plates = tau * Vp / factor;
      if (!surface.held(node, k)) {
        works.friction += (f0(dof, 0) + f1(dof, 0)) / 2 * by_plates;
      }
      if (!eta.empty()) {
        const double slip_rate = factor * (v0(dof, 0) + v1(dof, 0)) / 2 + Vp;
        const double du = u1(dof, 0) - u0(dof, 0);
        works.viscous += surface[node].weight * eta[node] * (Vp * du + slip_rate * by_plates);
      }
    }
  }
  works.load = works.friction + works.viscous;
  return works;
}

// Of this rank, in the first step: what r0 adds to the works of the forces at its beginning.
void EnergyBalance::addJump(Works& works) const
{
  auto const& surface = fault_.surface();
  auto const r0 = start_residual_->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const u0 = before_.u->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const u1 = after_.u->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto workAt = [&](int dof) { return r0(dof, 0) / 2 * (u1(dof, 0) - u0(dof, 0)); };
  for (int dof = 0; dof < body_.numOwnedDofs(); ++dof) {
    works.inertial += workAt(dof);
  }
  for (const int dof : fault_dofs_) {
    works.friction += workAt(dof);
    works.inertial -= workAt(dof);
  }
  const double tau = clock_.seconds(after_.time - before_.time);
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      const double by_plates = tau * surface.plateRate(node, k) / surface.slipFactor();
      const double work = r0(surface[node].dofs[k], 0) / 2 * by_plates;
      works.friction += work;
      works.load += work;
    }
  }
}

Energy const& EnergyBalance::advance(State const& state)
{
  fill(state, after_);
  auto of_body = worksOfStep();
  auto const of_plates = workOfPlates();
  if (!start_residual_.is_null()) {
    addJump(of_body);
    start_residual_ = Teuchos::null;
  }
  auto const [load, boundary, friction, viscous, inertial] =
    sumOverRanks(std::array<double, 5>{of_body.load + of_plates.load, of_body.boundary,
                                       of_body.friction + of_plates.friction,
                                       of_body.viscous + of_plates.viscous, of_body.inertial},
                 *body_.dofs->communicator());
  const double of_kinetic = after_.kinetic - before_.kinetic;
  const double numerical = inertial - of_kinetic;
  const double change = of_kinetic + after_.elastic - before_.elastic;
  energy_.kinetic = after_.kinetic;
  energy_.elastic = after_.elastic;
  energy_.load_work += load;
  energy_.boundary_work += boundary;
  energy_.friction_work += friction;
  energy_.viscous_work += viscous;
  energy_.numerical_dissipation += numerical;
  energy_.defect += change - (load + boundary - friction - viscous - numerical);
  std::swap(before_, after_);
  return energy_;
}
} // namespace asperity::dynamics
