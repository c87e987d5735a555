#include "dynamics/EnergyBalance.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/FaultMotion.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace asperity::dynamics
{
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
    , du_(body.vector())
    , work_(body.vector())
    , mean_(body.vector())
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
  return {body_.vector(), body_.vector(), body_.vector(),
          body_.vector(), body_.vector(), body_.vector()};
}

void EnergyBalance::fill(State const& state, Snapshot& result)
{
  Tpetra::deep_copy(*result.u, *state.u);
  Tpetra::deep_copy(*result.v, *state.v);
  Tpetra::deep_copy(*result.a, *state.a);
  result.time = state.time;
  const double t = clock_.seconds(state.time);
  body_.load(t, *result.load);

  // work = l - M a - C v - K u: what friction and reactions hold; kept where they act.
  Tpetra::deep_copy(*work_, *result.load);
  body_.applyMass(*state.a, *work_, -1, 1);
  body_.matrices.viscosity->apply(*state.v, *result.viscous_force);
  work_->update(-1, *result.viscous_force, 1);
  body_.matrices.stiffness->apply(*state.u, *mean_);
  work_->update(-1, *mean_, 1);
  result.elastic = 0.5 * mean_->dot(*state.u);
  body_.applyMass(*state.v, *mean_, 1, 0);
  result.kinetic = 0.5 * mean_->dot(*state.v);

  auto const& surface = fault_.surface();
  gatherSlip(surface, *state.v, v_);
  fault_.friction().linearise(v_, {state.alpha_of_rate, state.sigma_n}, gradient_, hessian_,
                              kinked_);
  auto const gradient = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gradient_);
  auto const v = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), v_);
  auto const residual = work_->getLocalViewHost(Tpetra::Access::ReadOnly);
  result.force->putScalar(0);
  auto const force = result.force->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < surface.numNodes(); ++node) {
    bool sliding = false;
    for (int k = 0; k < surface.numTangents(); ++k) {
      sliding = sliding || v(node, k) != 0;
    }
    for (int k = 0; k < surface.numTangents(); ++k) {
      const int dof = surface[node].dofs[k];
      force(dof, 0) = sliding ? gradient(node, k) : residual(dof, 0);
    }
  }
  for (int dof : body_.held.owned()) {
    force(dof, 0) = residual(dof, 0);
  }
}

double EnergyBalance::dotOver(std::vector<int> const& dofs, Vector const& x, Vector const& y) const
{
  auto const xs = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const ys = y.getLocalViewHost(Tpetra::Access::ReadOnly);
  double mine = 0;
  for (int dof : dofs) {
    mine += xs(dof, 0) * ys(dof, 0);
  }
  return sumOverRanks(mine, *body_.dofs->communicator());
}

void EnergyBalance::start(State const& state, Energy const& so_far)
{
  fill(state, before_);
  energy_ = so_far;
  energy_.kinetic = before_.kinetic;
  energy_.elastic = before_.elastic;
}

// Of the step from before_ to after_, whose du_ is known.
double EnergyBalance::numericalDissipation()
{
  mean_->update(0.5, *before_.a, 0.5, *after_.a, 0);
  body_.applyMass(*mean_, *work_, 1, 0);
  const double work_of_inertia = du_->dot(*work_);
  mean_->update(1, *after_.v, -1, *before_.v, 0);
  body_.applyMass(*mean_, *work_, 1, 0);
  mean_->update(0.5, *before_.v, 0.5, *after_.v, 0);
  return work_of_inertia - mean_->dot(*work_);
}

// Of the step from before_ to after_, whose du_ is known: the parts of friction_work and
// viscous_work that the motion of the plates adds, and the load_work that they do in it. A part of
// radiation damping's traction, eta Vp, is a load of the body (fem::addRadiationOfPlates): its work
// is moved from the loads to what damping dissipates.
Energy EnergyBalance::workOfPlates() const
{
  Energy mine;
  auto const& surface = fault_.surface();
  if (!surface.hasPlateRate()) {
    return mine;
  }
  const double tau = clock_.seconds(after_.time - before_.time);
  const double factor = surface.slipFactor();
  auto const& eta = fault_.laws().radiation_damping;
  auto const f0 = before_.force->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const f1 = after_.force->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const v0 = before_.v->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const v1 = after_.v->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const du = du_->getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      const int dof = surface[node].dofs[k];
      const double Vp = surface.plateRate(node, k);
      const double by_plates = tau * Vp / factor;
      if (!surface.held(node, k)) {
        mine.friction_work += (f0(dof, 0) + f1(dof, 0)) / 2 * by_plates;
      }
      if (!eta.empty()) {
        const double slip_rate = factor * (v0(dof, 0) + v1(dof, 0)) / 2 + Vp;
        mine.viscous_work +=
          surface[node].weight * eta[node] * (Vp * du(dof, 0) + slip_rate * by_plates);
      }
    }
  }
  Energy result;
  auto const& communicator = *body_.dofs->communicator();
  result.friction_work = sumOverRanks(mine.friction_work, communicator);
  result.viscous_work = sumOverRanks(mine.viscous_work, communicator);
  result.load_work = result.friction_work + result.viscous_work;
  return result;
}

Energy const& EnergyBalance::advance(State const& state)
{
  fill(state, after_);
  du_->update(1, *after_.u, -1, *before_.u, 0);

  mean_->update(0.5, *before_.load, 0.5, *after_.load, 0);
  auto const of_plates = workOfPlates();
  const double load = mean_->dot(*du_) + of_plates.load_work;
  mean_->update(0.5, *before_.force, 0.5, *after_.force, 0);
  const double friction = dotOver(fault_dofs_, *mean_, *du_) + of_plates.friction_work;
  const double boundary = -dotOver(body_.held.owned(), *mean_, *du_);
  mean_->update(0.5, *before_.viscous_force, 0.5, *after_.viscous_force, 0);
  const double viscous = mean_->dot(*du_) + of_plates.viscous_work;
  const double numerical = numericalDissipation();

  const double change = after_.kinetic - before_.kinetic + after_.elastic - before_.elastic;
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
