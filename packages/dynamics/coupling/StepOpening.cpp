#include "dynamics/coupling/StepOpening.hpp"

#include <Tpetra_Vector.hpp>

#include <limits>

namespace asperity::dynamics
{
namespace
{
// lower and upper(num_nodes): infinite at nodes that cannot open.
void setBounds(fem::FaultSurface const& surface, Vector const& u_start, Vector const& u_hat,
               double per_velocity, bool stops, NodeView const& lower, NodeView const& upper)
{
  auto const u0 = u_start.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const u = u_hat.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const opens = surface.openingNodes();
  auto const across = surface.dofsAcross();
  auto const sign = surface.openingSigns();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Kokkos::parallel_for(
    "asperity::dynamics::setBounds", RangePolicy(0, opens.extent_int(0)), KOKKOS_LAMBDA(int node) {
      const double start = sign(node) * u0(across(node), 0);
      const double room = sign(node) * u(across(node), 0) - (stops && start < 0 ? start : 0);
      double least = -room / per_velocity; // of the rate of opening
      least = stops && least > 0 ? 0 : least;
      lower(node) = opens(node) && sign(node) > 0 ? least : -infinity;
      upper(node) = opens(node) && sign(node) < 0 ? -least : infinity;
    });
}
} // namespace

StepOpening::StepOpening(Body const& body, Fault const& fault, RateUpdate const& update,
                         ReactionSinceStart const& since_start)
    : body_(body)
    , surface_(fault.surface())
    , update_(update)
    , at_end_(fault, since_start)
    , lower_("asperity::dynamics::leastVelocity", surface_.numNodes())
    , upper_("asperity::dynamics::largestVelocity", surface_.numNodes())
    , bounds_{true, lower_, upper_}
    , w_("asperity::dynamics::velocityAtOpening", surface_.numNodes(), surface_.numUnknowns())
{
  if (!body.matrices.is_massless && update.acceleration_in_acceleration != 0) {
    at_start_.emplace(fault, since_start);
    load_ = body.vector();
    start_ = body.vector();
    before_ = NodeView("asperity::dynamics::withoutForcesAcross", surface_.numNodes());
    carried_ = NodeView("asperity::dynamics::carriedForce", surface_.numNodes());
  }
}

void StepOpening::evaluate(double t0, double t1)
{
  at_end_.evaluate(t1);
  if (at_start_) {
    at_start_->evaluate(t0);
    body_.load(t0, *load_);
  }
}

void StepOpening::begin(State const& from, double tau, Vector const& u_hat)
{
  setBounds(surface_, *from.u, u_hat, tau * update_.stiffness_weight, at_start_.has_value(), lower_,
            upper_);
  if (at_start_) {
    at_start_->add(from, *load_);
    body_.residual(*load_, from.motion(), *start_); // which b has with the M a0 of its a^
  }
}

void StepOpening::add(State const& to, Vector& b)
{
  if (!at_start_) {
    at_end_.add(to, b);
    return;
  }
  auto const across = surface_.dofsAcross();
  auto const opens = surface_.openingNodes();
  auto const before = before_, carried = carried_;
  const RangePolicy nodes(0, surface_.numNodes());
  {
    auto const values = b.getLocalViewDevice(Tpetra::Access::ReadOnly);
    Kokkos::parallel_for(
      "asperity::dynamics::beforeForcesAcross", nodes,
      KOKKOS_LAMBDA(int node) { before(node) = values(across(node), 0); });
  }
  at_end_.add(to, b);
  auto const values = b.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const start = start_->getLocalViewDevice(Tpetra::Access::ReadOnly);
  Kokkos::parallel_for(
    "asperity::dynamics::forcesAcross", nodes, KOKKOS_LAMBDA(int node) {
      const int dof = across(node);
      carried(node) = opens(node) ? values(dof, 0) - before(node) - start(dof, 0) : 0;
      values(dof, 0) += opens(node) ? start(dof, 0) : 0;
    });
}

void StepOpening::clearWhereOpen(RateSolver const& solver, NodeView const& R) const
{
  solver.faultVelocity(w_);
  auto const w = w_;
  auto const stress = at_end_.stress();
  auto const opens = surface_.openingNodes();
  auto const lower = lower_, upper = upper_;
  const int last = w.extent_int(1) - 1;
  Kokkos::parallel_for(
    "asperity::dynamics::clearWhereOpen", RangePolicy(0, R.extent_int(0)), KOKKOS_LAMBDA(int node) {
      if (opens(node) && w(node, last) > lower(node) && w(node, last) < upper(node)) {
        R(node) = -stress(node);
      }
    });
}
} // namespace asperity::dynamics
