#include "unit/dynamics/DenseReference.hpp"

#include <cmath>

namespace asperity::dynamics::testing
{
DenseState denseOf(State const& state)
{
  return {denseOf(*state.u), denseOf(*state.v), denseOf(*state.a), denseOf(state.alpha)};
}

DenseReference::DenseReference(Model const& model, Scheme scheme, double beta, double lambda)
    : model_(model)
    , scheme_(scheme)
    , beta_(beta)
    , lambda_(lambda)
    , mass_(denseOf(*model.body.matrices.mass))
    , viscosity_(denseOf(*model.body.matrices.viscosity))
    , stiffness_(denseOf(*model.body.matrices.stiffness))
{
  for (int dof = 0; dof < model.body.numOwnedDofs(); ++dof) {
    if (!model.body.fixed[dof]) {
      free_.push_back(dof);
    }
  }
}

// mu = a asinh(V / (2 V*) exp((mu* + b alpha) / a)) after theta' = 1 - V theta / L over tau at the
// rate |lambda v0 + (1 - lambda) v1|.
DenseReference::NodalFriction DenseReference::friction(int i, double v0, double v1, double alpha0,
                                                       double tau) const
{
  auto const& o = model_.options;
  const double V = o.slip_factor * std::abs(lambda_ * v0 + (1 - lambda_) * v1);
  const double theta0 = o.L / o.reference_rate * std::exp(alpha0);
  const double left = std::exp(-V * tau / o.L);
  const double theta1 = V > 0 ? theta0 * left + o.L / V * (1 - left) : theta0 + tau;
  const double alpha = std::log(theta1 * o.reference_rate / o.L);
  const double mu = o.a * std::asinh(o.slip_factor * v1 / (2 * o.reference_rate) *
                                     std::exp((o.reference_friction + o.b * alpha) / o.a));
  const double sign = v1 > 0 ? 1 : -1;
  return {model_.fault_nodes.weights[i] * (o.sigma_n * mu + o.cohesion * sign), alpha};
}

void DenseReference::complete(DenseState const& from, double tau, DenseState& to) const
{
  if (scheme_ == Scheme::newmark) {
    to.a = 2 / tau * (to.v - from.v) - from.a;
    to.u = from.u + tau * from.v + tau * tau / 2 * ((1 - 2 * beta_) * from.a + 2 * beta_ * to.a);
  } else {
    to.a = (to.v - from.v) / tau;
    to.u = from.u + tau * to.v;
  }
}

Eigen::VectorXd DenseReference::imbalance(DenseState const& from, double tau,
                                          Eigen::VectorXd const& load, DenseState& to) const
{
  complete(from, tau, to);
  Eigen::VectorXd sum = mass_ * to.a + viscosity_ * to.v + stiffness_ * to.u - load;
  for (int i = 0; i < model_.fault.numNodes(); ++i) {
    const int dof = model_.fault.dofs[i][0];
    auto const nodal = friction(i, from.v[dof], to.v[dof], from.alpha[i], tau);
    sum[dof] += nodal.force;
    to.alpha[i] = nodal.alpha;
  }
  return sum(free_);
}

DenseState DenseReference::step(DenseState const& from, double t1, double tau) const
{
  auto load = model_.body.vector();
  auto prescribed = model_.body.vector();
  model_.body.load(t1, *load);
  model_.body.prescribed_velocity(t1, *prescribed);
  const Eigen::VectorXd l = denseOf(*load);

  DenseState to = from;
  to.v = denseOf(*prescribed);
  to.v(free_) = from.v(free_);
  const bool newmark = scheme_ == Scheme::newmark;
  const Eigen::MatrixXd Z =
    (newmark ? 2 : 1) / tau * mass_ + viscosity_ + (newmark ? 2 * beta_ : 1) * tau * stiffness_;
  Eigen::VectorXd rest = imbalance(from, tau, l, to);
  for (int iteration = 0; iteration < 100; ++iteration) {
    Eigen::MatrixXd jacobian = Z;
    for (int i = 0; i < model_.fault.numNodes(); ++i) {
      const int dof = model_.fault.dofs[i][0];
      const double h = 1e-6 * std::abs(to.v[dof]);
      auto const force = [&](double v) {
        return friction(i, from.v[dof], v, from.alpha[i], tau).force;
      };
      jacobian(dof, dof) += (force(to.v[dof] + h) - force(to.v[dof] - h)) / (2 * h);
    }
    const Eigen::VectorXd change = jacobian(free_, free_).lu().solve(rest);
    // Halved while it leads to a larger imbalance, or across a standstill of the fault.
    DenseState next = to;
    for (double length = 1; length > 1e-6; length /= 2) {
      next.v(free_) = to.v(free_) - length * change;
      const Eigen::VectorXd next_rest = imbalance(from, tau, l, next);
      if (next_rest.norm() < rest.norm()) {
        rest = next_rest;
        to = next;
        break;
      }
    }
    if (change.norm() <= 1e-13 * to.v.norm()) {
      break;
    }
  }
  return to;
}
} // namespace asperity::dynamics::testing
