#include "dynamics/coupling/NormalStressUpdate.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/coupling/StepOpening.hpp"
#include "dynamics/coupling/StressScale.hpp"

namespace asperity::dynamics
{
namespace
{
void subtract(ConstNodeView const& b, NodeView const& r)
{
  Kokkos::parallel_for(
    "asperity::dynamics::reactionAcross", RangePolicy(0, r.extent(0)),
    KOKKOS_LAMBDA(int node) { r(node) -= b(node); });
}

// r := (r + carried) / 2 at nodes that may open
void takeForceOfContact(ConstFlagView const& opens, ConstNodeView const& carried, NodeView const& r)
{
  Kokkos::parallel_for(
    "asperity::dynamics::forceOfContactInStep", RangePolicy(0, carried.extent_int(0)),
    KOKKOS_LAMBDA(int node) { r(node) = opens(node) ? (r(node) + carried(node)) / 2 : r(node); });
}

// result := the larger of a and b at each node
void setLarger(ConstNodeView const& a, ConstNodeView const& b, NodeView const& result)
{
  Kokkos::parallel_for(
    "asperity::dynamics::largerStress", RangePolicy(0, result.extent_int(0)),
    KOKKOS_LAMBDA(int node) { result(node) = a(node) > b(node) ? a(node) : b(node); });
}
} // namespace

NormalStressUpdate::NormalStressUpdate(Body const& body, Fault const& fault,
                                       ReactionSinceStart const& since_start)
    : body_(body)
    , fault_(fault)
    , change_(fault.normalStress().change())
    , since_start_(since_start)
    , sigma_0_("asperity::dynamics::sigma0", fault.surface().numNodes())
{
  if (change_ != NormalStressChange::fixed) {
    ASPERITY_ASSERT(since_start_.reaction);
    load_ = body.vector();
    R_ = NodeView("asperity::dynamics::compression", sigma_0_.extent(0));
    right_side_ = NodeView("asperity::dynamics::rightSideAcross", sigma_0_.extent(0));
    scale_ = NodeView("asperity::dynamics::perPascal", sigma_0_.extent(0));
  }
}

void NormalStressUpdate::evaluate(double t0, double t1)
{
  fault_.normalStress().at(t1, sigma_0_);
  if (change_ == NormalStressChange::lagged) {
    body_.load(t0, *load_);
  }
}

void NormalStressUpdate::begin(StepStart const& start)
{
  auto const& sigma_n = start.to.sigma_n;
  switch (change_) {
  case NormalStressChange::fixed:
    Kokkos::deep_copy(sigma_n, sigma_0_);
    limit(sigma_n);
    break;
  case NormalStressChange::lagged:
    since_start_.reaction->compression(*load_, start.from.motion(), R_);
    fault_.normalStress().add(sigma_0_, R_, since_start_.at_start, sigma_n);
    break;
  case NormalStressChange::coupled:
    setScaleOfStress(stressOfScale(start.from.sigma_n), fault_.surface(), scale_);
    limit(sigma_n);
    break;
  }
}

// The stress of a fault that is open is zero, but the one that it has when it closes decides what
// matters: so that at the start counts, where it is larger.
ConstNodeView NormalStressUpdate::stressOfScale(ConstNodeView const& sigma_n) const
{
  if (!fault_.surface().mayOpen()) {
    return sigma_n;
  }
  setLarger(sigma_n, sigma_0_, R_);
  return R_;
}

void NormalStressUpdate::setRightSide(Vector const& b)
{
  if (coupled()) {
    since_start_.reaction->gather(b, right_side_);
  }
}

int NormalStressUpdate::respond(StepIterate const& step, NodeView const& image)
{
  ASPERITY_TIME_WORK("normal stress");
  step.solver.reactions(R_);
  subtract(right_side_, R_);
  auto const* const opening = step.opening;
  if (opening != nullptr && opening->carried().extent(0) > 0) {
    takeForceOfContact(fault_.surface().openingNodes(), opening->carried(), R_);
  }
  since_start_.reaction->compression(R_, R_);
  if (opening != nullptr) {
    opening->clearWhereOpen(step.solver, R_);
  }
  fault_.normalStress().add(sigma_0_, R_, since_start_.at_start, image);
  return 0;
}

void NormalStressUpdate::limit(NodeView const& sigma_n) const
{
  fault_.normalStress().raiseToFloor(sigma_n);
}
} // namespace asperity::dynamics
