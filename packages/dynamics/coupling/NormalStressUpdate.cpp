#include "dynamics/coupling/NormalStressUpdate.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
using Nodes = Kokkos::RangePolicy<friction::ExecutionSpace>;

constexpr double friction_over_b = 50;
// See perPascal(): relative changes of a normal stress near zero do not matter.
constexpr double small_share = 1e-2;

double largest(friction::ConstNodeView const& values)
{
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::largestNormalStress", Nodes(0, values.extent(0)),
    KOKKOS_LAMBDA(int node, double& maximum) {
      maximum = maximum < values(node) ? values(node) : maximum;
    },
    Kokkos::Max<double>(result));
  return std::max(result, 0.); // a rank without nodes has no maximum
}
} // namespace

NormalStressUpdate::NormalStressUpdate(Body const& body, Fault const& fault,
                                       ReactionSinceStart const& since_start)
    : body_(body)
    , fault_(fault)
    , change_(fault.normalStress().change())
    , since_start_(since_start)
{
  if (change_ == NormalStressChange::fixed) {
    return;
  }
  ASPERITY_ASSERT(since_start_.reaction);
  const int size = fault.surface().numNodes();
  load_ = body.vector();
  sigma_0_ = friction::NodeView("asperity::dynamics::sigma0", size);
  R_ = friction::NodeView("asperity::dynamics::compression", size);
  scale_ = friction::NodeView("asperity::dynamics::perPascal", size);
  per_pascal_ = scale_;
}

void NormalStressUpdate::evaluate(double t0, double t1)
{
  if (change_ != NormalStressChange::fixed) {
    fault_.normalStress().at(t1, sigma_0_);
  }
  if (lagged()) {
    body_.load(t0, *load_);
  }
}

void NormalStressUpdate::begin(State const& from, friction::NodeView const& sigma_n)
{
  auto const& stress = fault_.normalStress();
  if (lagged()) {
    since_start_.reaction->compression(*load_, *from.u, *from.v, *from.a, R_);
    stress.add(sigma_0_, R_, since_start_.at_start, sigma_n);
  }
  if (coupled()) {
    stress.raiseToFloor(sigma_n); // an extrapolated guess may be below it
    const double most = maxOverRanks(largest(from.sigma_n), *fault_.surface().communicator());
    const double least = most > 0 ? small_share * most : 1;
    auto const scale = scale_;
    auto const before = from.sigma_n;
    Kokkos::parallel_for(
      "asperity::dynamics::scaleOfNormalStress", Nodes(0, scale.extent(0)),
      KOKKOS_LAMBDA(int node) {
        scale(node) = friction_over_b / (before(node) > least ? before(node) : least);
      });
  }
}

void NormalStressUpdate::takeRightSide(Vector const& b)
{
  if (coupled()) {
    since_start_.reaction->gather(b, right_side_);
  }
}

void NormalStressUpdate::respond(RateSolver const& solver, friction::NodeView const& sigma_n)
{
  ASPERITY_TIME_WORK("normal stress");
  auto r = solver.reactions();
  for (std::size_t i = 0; i < r.size(); ++i) {
    r[i] -= right_side_[i];
  }
  since_start_.reaction->compression(r, R_);
  fault_.normalStress().add(sigma_0_, R_, since_start_.at_start, sigma_n);
}
} // namespace asperity::dynamics
