#include "dynamics/observables/EnergyBalance.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "dynamics/observables/DofSums.hpp"
#include "dynamics/observables/StartForces.hpp"
#include "fem/inelastic/InelasticCells.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace asperity::dynamics
{
namespace
{
// A force at a dof over a step: the mean over the ends of the step, and the work in it.
struct ForceOfStep
{
  DofValues u0, u1, f0, f1;
  KOKKOS_INLINE_FUNCTION double mean(int dof) const { return (f0(dof, 0) + f1(dof, 0)) / 2; }
  KOKKOS_INLINE_FUNCTION double motion(int dof) const { return u1(dof, 0) - u0(dof, 0); }
  KOKKOS_INLINE_FUNCTION double operator()(int dof) const { return mean(dof) * motion(dof); }
};

// The mean displacement over a step times the change of a force.
struct WorkOfChange
{
  DofValues u0, u1, f0, f1;
  KOKKOS_INLINE_FUNCTION double operator()(int dof) const
  {
    return (u0(dof, 0) + u1(dof, 0)) / 2 * (f1(dof, 0) - f0(dof, 0));
  }
};

// l - M a - C v - K u at a dof.
struct Residual
{
  DofValues load, inertial, viscous, elastic;
  KOKKOS_INLINE_FUNCTION double operator()(int dof) const
  {
    return load(dof, 0) - inertial(dof, 0) - viscous(dof, 0) - elastic(dof, 0);
  }
};

// Sets the result at the dofs of the fault to friction, at nodes at rest to the residual, which
// friction balances, and at held dofs to the reaction. A node rests under back slip, too, where the
// slip rate is less than 1e-10 of the plate rate, so that rounding spoils its logarithm, on which
// friction depends; there the balance of energy closes by itself.
void setForce(fem::FaultSurface const& surface, IndexView const& held, ConstBlockView const& w,
              ConstBlockView const& friction, Residual const& residual, Vector& result)
{
  auto const force = result.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = surface.dofs();
  constexpr double resolved = 1e-10;
  const bool plates_move = surface.hasPlateRate();
  auto const rates = surface.plateRates();
  const double factor = surface.slipFactor();
  Kokkos::parallel_for(
    "asperity::dynamics::forceOnFault", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int node) {
      const int size = dofs.extent_int(1);
      const double of_plates = plates_move ? motionOfPlates(rates, node, size, factor) : 0;
      bool sliding = false;
      for (int k = 0; k < size; ++k) {
        sliding = sliding || math::fabs(w(node, k)) > resolved * of_plates;
      }
      for (int k = 0; k < size; ++k) {
        force(dofs(node, k), 0) = sliding ? friction(node, k) : residual(dofs(node, k));
      }
    });
  Kokkos::parallel_for(
    "asperity::dynamics::reactions", RangePolicy(0, held.extent_int(0)),
    KOKKOS_LAMBDA(int i) { force(held(i), 0) = residual(held(i)); });
}

// Sets the result at these dofs to the residual, which contact balances.
void setForceOfContact(IndexView const& across, Residual const& residual, Vector& result)
{
  auto const force = result.getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::dynamics::forceOfContact", RangePolicy(0, across.extent_int(0)),
    KOKKOS_LAMBDA(int i) { force(across(i), 0) = residual(across(i)); });
}

// What friction and radiation damping dissipate because plates move along the fault.
struct TakenFromPlates
{
  double friction = 0, damping = 0;
};

// What the motion of the plates adds to the works, at this rank's nodes in a step of tau [s] with
// the velocities v0 and v1 at its ends.
TakenFromPlates takenFromPlates(fem::FaultSurface const& surface, ConstNodeView const& eta,
                                double tau, ForceOfStep const& force, DofValues const& v0,
                                DofValues const& v1)
{
  const double factor = surface.slipFactor();
  auto const dofs = surface.dofs();
  auto const held = surface.heldDofs();
  auto const weight = surface.weights();
  auto const rates = surface.plateRates();
  const bool is_damped = eta.extent(0) > 0;
  TakenFromPlates works;
  Kokkos::parallel_reduce(
    "asperity::dynamics::takenFromPlates", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int node, double& friction, double& damping) {
      for (int k = 0; k < dofs.extent_int(1); ++k) {
        const int dof = dofs(node, k);
        const double Vp = rates(node * dofs.extent_int(1) + k);
        const double by_plates = tau * Vp / factor;
        if (!held(dof)) {
          friction += force.mean(dof) * by_plates;
        }
        if (is_damped) {
          const double slip_rate = factor * (v0(dof, 0) + v1(dof, 0)) / 2 + Vp;
          damping += weight(node) * eta(node) * (Vp * force.motion(dof) + slip_rate * by_plates);
        }
      }
    },
    works.friction, works.damping);
  return works;
}
} // namespace

std::array<Energy::Member, 10> const& Energy::members()
{
  static constexpr std::array<Member, 10> all = {
    {{"kinetic", &Energy::kinetic},
     {"elastic", &Energy::elastic},
     {"load_work", &Energy::load_work},
     {"boundary_work", &Energy::boundary_work},
     {"friction_work", &Energy::friction_work},
     {"viscous_work", &Energy::viscous_work},
     {"inelastic_work", &Energy::inelastic_work},
     {"contact_work", &Energy::contact_work},
     {"numerical_dissipation", &Energy::numerical_dissipation},
     {"defect", &Energy::defect}}};
  return all;
}

EnergyBalance::EnergyBalance(Body const& body, Fault const& fault, DyadicTime const& clock,
                             ReactionSinceStart const& since_start)
    : body_(body)
    , fault_(fault)
    , clock_(clock)
    , before_(snapshot())
    , after_(snapshot())
    , momentum_(body.vector())
    , eta_(toDevice(fault.laws().radiation_damping, "asperity::dynamics::radiationDamping"))
    , w_("asperity::dynamics::w", fault.surface().numNodes(), fault.surface().numTangents())
    , gradient_("asperity::dynamics::gradient", fault.surface().numNodes(),
                fault.surface().numTangents())
    , hessian_("asperity::dynamics::hessian", fault.surface().numNodes(),
               fault.surface().numTangents(), fault.surface().numTangents())
    , kinked_("asperity::dynamics::kinked", fault.surface().numNodes())
{
  auto const& surface = fault.surface();
  std::vector<int> dofs, across;
  for (int node = 0; node < surface.numNodes(); ++node) {
    auto const& of_node = surface[node].dofs;
    std::copy_if(of_node.begin(), of_node.end(), std::back_inserter(dofs),
                 [&](int dof) { return !body.held[dof]; });
    if (surface.opens(node)) {
      across.push_back(surface[node].across);
    }
  }
  fault_dofs_ = toDevice(dofs, "asperity::dynamics::faultDofs");
  dofs_across_ = toDevice(across, "asperity::dynamics::dofsAcross");
  if (surface.mayOpen()) {
    opening_.emplace(fault, since_start);
  }
}

EnergyBalance::Snapshot EnergyBalance::snapshot() const
{
  return {body_.vector(), body_.vector(),        body_.vector(),
          body_.vector(), body_.branchVectors(), body_.noForces()};
}

void EnergyBalance::fill(State const& state, Snapshot& result)
{
  Tpetra::deep_copy(*result.u, *state.u);
  Tpetra::deep_copy(*result.v, *state.v);
  result.time = state.time;
  body_.load(clock_.seconds(state.time), *result.load);
  if (opening_) {
    opening_->evaluate(clock_.seconds(state.time));
    opening_->add(state, *result.load);
  }
  body_.computeForces(state.motion(), result.resisting, momentum_.get());
  result.elastic = 0.5 * result.resisting.elastic->dot(*state.u);
  for (std::size_t k = 0; k < result.d.size(); ++k) {
    auto const& f = *result.resisting.branch_forces[k];
    result.elastic += 0.5 * (f.dot(*state.branches[k]) - f.dot(*state.u));
    Tpetra::deep_copy(*result.d[k], *state.branches[k]);
  }
  if (state.inelastic) {
    result.inelastic = body_.cells->energy(state.inelastic->strain);
    result.elastic += result.inelastic - 0.5 * result.resisting.inelastic->dot(*state.u);
  }
  result.kinetic = 0.5 * momentum_->dot(*state.v);
  fillForce(state, result);
}

void EnergyBalance::fillForce(State const& state, Snapshot const& at)
{
  auto const& surface = fault_.surface();
  gatherSlip(surface, *state.v, w_);
  fault_.friction().linearise(w_, {state.alpha_of_rate, fault_.given(state).sigma_n}, gradient_,
                              hessian_, kinked_);
  at.force->putScalar(0);
  const Residual residual = {reading(*at.load), reading(*at.resisting.inertial),
                             reading(*at.resisting.viscous), reading(*at.resisting.elastic)};
  setForce(surface, body_.held.ownedOnDevice(), w_, gradient_, residual, *at.force);
  if (opening_) {
    setForceOfContact(dofs_across_, residual, *at.force);
  }
}

void EnergyBalance::start(State const& state)
{
  resume(state, {});
  const StartForces forces = {*before_.load, before_.resisting, *before_.force};
  if (body_.matrices.is_massless) {
    start_residual_ = residualAtStart(body_, forces);
    start_imbalance_ = dynamics::startImbalance(body_, fault_dofs_, forces, *start_residual_);
  } else {
    start_contradiction_ = dynamics::startContradiction(body_, fault_.surface(), forces);
  }
}

void EnergyBalance::resume(State const& state, Energy const& so_far)
{
  start_residual_ = Teuchos::null;
  start_imbalance_ = start_contradiction_ = 0;
  fill(state, before_);
  energy_ = so_far;
  energy_.kinetic = before_.kinetic;
  energy_.elastic = before_.elastic;
}

// The works of this rank in the step from before_ to after_. The loads supply what the motion of
// the plates adds to the works of friction and of radiation damping. The part eta Vp of the
// traction of radiation damping is a load of the body (fem::addRadiationOfPlates): its work is
// moved from the loads to what damping dissipates.
EnergyBalance::Works EnergyBalance::worksOfStep() const
{
  const auto during = [&](Vector const& f0, Vector const& f1) {
    return ForceOfStep{reading(*before_.u), reading(*after_.u), reading(f0), reading(f1)};
  };
  auto const &then = before_.resisting, &now = after_.resisting;
  auto const force = during(*before_.force, *after_.force);
  const int num_dofs = body_.numOwnedDofs();
  Works works;
  works.load = sumOfAll(num_dofs, during(*before_.load, *after_.load));
  works.viscous = sumOfAll(num_dofs, during(*then.viscous, *now.viscous));
  works.inertial = sumOfAll(num_dofs, during(*then.inertial, *now.inertial));
  for (std::size_t k = 0; k < before_.d.size(); ++k) {
    auto const &f0 = *then.branch_forces[k], &f1 = *now.branch_forces[k];
    works.viscous += sumOfAll(num_dofs, during(f0, f1)) -
                     sumOfAll(num_dofs, ForceOfStep{reading(*before_.d[k]), reading(*after_.d[k]),
                                                    reading(f0), reading(f1)});
  }
  if (body_.cells) {
    const WorkOfChange work{reading(*before_.u), reading(*after_.u), reading(*then.inelastic),
                            reading(*now.inelastic)};
    works.inelastic = sumOfAll(num_dofs, work);
  }
  works.friction = sumAt(fault_dofs_, force);
  works.contact = opening_ ? sumAt(dofs_across_, force) : 0;
  works.boundary = -sumAt(body_.held.ownedOnDevice(), force);
  if (fault_.surface().hasPlateRate()) {
    const double tau = clock_.seconds(after_.time - before_.time);
    const auto of_plates =
      takenFromPlates(fault_.surface(), eta_, tau, force, reading(*before_.v), reading(*after_.v));
    works.load += of_plates.friction + of_plates.damping;
    works.friction += of_plates.friction;
    works.viscous += of_plates.damping;
  }
  return works;
}

// A quasi-dynamic body begins its first step with the forces after the jump: r0 acts on the fault
// as friction, and inside the body in place of the inertia that it does not have.
void EnergyBalance::jump()
{
  before_.force->update(1, *start_residual_, 1);
  before_.resisting.inertial->update(1, *start_residual_, 1);
  clearAt(fault_dofs_, *before_.resisting.inertial);
  start_residual_ = Teuchos::null;
}

Energy const& EnergyBalance::advance(State const& state)
{
  fill(state, after_);
  if (!start_residual_.is_null()) {
    jump();
  }
  auto const mine = worksOfStep();
  auto const [load, boundary, friction, viscous, of_forces, inertial, contact] =
    sumOverRanks(std::array<double, 7>{mine.load, mine.boundary, mine.friction, mine.viscous,
                                       mine.inelastic, mine.inertial, mine.contact},
                 *body_.dofs->communicator());
  const double inelastic = of_forces - (after_.inelastic - before_.inelastic);
  const double of_kinetic = after_.kinetic - before_.kinetic;
  const double numerical = inertial - of_kinetic;
  const double change = of_kinetic + after_.elastic - before_.elastic;
  energy_.kinetic = after_.kinetic;
  energy_.elastic = after_.elastic;
  energy_.load_work += load;
  energy_.boundary_work += boundary;
  energy_.friction_work += friction;
  energy_.viscous_work += viscous;
  energy_.inelastic_work += inelastic;
  energy_.contact_work += contact;
  energy_.numerical_dissipation += numerical;
  energy_.defect +=
    change - (load + boundary - friction - viscous - inelastic - numerical - contact);
  std::swap(before_, after_);
  return energy_;
}
} // namespace asperity::dynamics
