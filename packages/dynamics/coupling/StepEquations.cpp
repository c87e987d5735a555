#include "dynamics/coupling/StepEquations.hpp"

#include "base/parallel/Agreement.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/fault/FaultMotion.hpp"

namespace asperity::dynamics
{
StepEquations::StepEquations(Body const& body, Fault const& fault, RateUpdate const& update,
                             StepUnknowns const& unknowns, ReactionSinceStart const& since_start)
    : body_(body)
    , surface_(fault.surface())
    , update_(update)
    , unknowns_(unknowns)
    , v_D_(body.vector())
    , u_hat_(body.vector())
    , a_hat_(body.vector())
    , b_(body.vector())
    , b_without_unknowns_(unknowns.addForces() || surface_.mayOpen() ? body.vector()
                                                                     : Teuchos::null)
    , forces_(body.noForces())
    , mean_offset_("asperity::dynamics::meanOffset", surface_.numNodes(), surface_.numTangents())
    , prescribed_part_("asperity::dynamics::prescribedBeside", surface_.numNodes(),
                       surface_.numTangents())
    , u_(body.vector())
    , v_(body.vector())
    , a_(body.vector())
    , d_(body.branchVectors())
{
  if (surface_.mayOpen()) {
    opening_.emplace(body, fault, update, since_start);
  }
}

void StepEquations::begin(State const& from, double tau, double t0, double t1)
{
  ASPERITY_TIME_WORK("right sides of steps");
  // An expression may be nan on one rank alone.
  onEveryRank(*surface_.communicator(), [&] {
    unknowns_.evaluate(t0, t1);
    body_.prescribed_velocity(t1, *v_D_);
    has_prescribed_part_ = gatherPrescribedPart(surface_, *v_D_, prescribed_part_);
    setZeroSlipRate(surface_, *v_D_);
    body_.load(t1, *b_);
    if (opening_) {
      opening_->evaluate(t0, t1);
    }
  });

  update_.predict(from, tau, *u_hat_, *a_hat_);
  if (opening_) {
    opening_->begin(from, tau, *u_hat_);
  }
  update_.withVelocity(*v_D_, *u_hat_, *a_hat_, tau, *u_, *a_);
  RateUpdate::relax(body_.matrices, from, tau, *u_, d_);
  body_.computeForces({*u_, *v_D_, *a_, d_}, forces_);
  forces_.subtractFrom(*b_);
  if (!b_without_unknowns_.is_null()) {
    Tpetra::deep_copy(*b_without_unknowns_, *b_);
  }

  Vector& mean = *u_;
  update_.meanVelocity(from, tau, *v_D_, surface_.dofs(), mean);
  gatherSlip(surface_, mean, mean_offset_);
}

Vector const& StepEquations::setRightSide(State const& to)
{
  if (!b_without_unknowns_.is_null()) {
    Tpetra::deep_copy(*b_, *b_without_unknowns_);
    unknowns_.addForces(to, *b_);
  }
  unknowns_.setRightSide(*b_);
  if (opening_) {
    opening_->add(to, *b_); // the unknowns have b without these forces, which are no reaction
  }
  body_.clearHeld(*b_);
  return *b_;
}

void StepEquations::removePrescribed(Vector const& v, Vector& w) const
{
  w.update(1, v, -1, *v_D_, 0);
  body_.clearHeld(w);
}

void StepEquations::addPrescribed(Vector const& w, Vector& v) const
{
  if (&v == &w) {
    v.update(1, *v_D_, 1);
  } else {
    v.update(1, w, 1, *v_D_, 0);
  }
}

FrictionProblem StepEquations::withPrescribed(FrictionProblem const& friction) const
{
  return has_prescribed_part_ ? friction.withPrescribed(prescribed_part_) : friction;
}

void StepEquations::takeMean(BlockView const& blocks) const
{
  auto const offset = mean_offset_;
  const double weight = update_.stiffness_weight;
  Kokkos::parallel_for(
    "asperity::dynamics::meanVelocity", RangePolicy(0, blocks.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < blocks.extent_int(1); ++k) {
        blocks(node, k) = offset(node, k) + weight * blocks(node, k);
      }
    });
}

Vector const& StepEquations::displacementAtEnd(Vector const& w, double tau)
{
  addPrescribed(w, *v_);
  update_.withVelocity(*v_, *u_hat_, *a_hat_, tau, *u_, *a_);
  return *u_;
}

void StepEquations::complete(State const& from, double tau, State& to) const
{
  update_.complete(from, *u_hat_, *a_hat_, tau, to);
  RateUpdate::relax(body_.matrices, from, tau, *to.u, to.branches);
}
} // namespace asperity::dynamics
