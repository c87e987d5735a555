#include "unit/dynamics/DenseReference.hpp"

#include <cmath>

namespace asperity::dynamics::test
{
DenseState denseOf(State const& state)
{
  return {denseOf(*state.u), denseOf(*state.v), denseOf(*state.a), denseOf(*state.jerk),
          denseOf(state.alpha)};
}

DenseReference::DenseReference(Model const& model, Scheme scheme, double parameter)
    : model_(model)
    , scheme_(scheme)
    , parameter_(parameter)
    , mass_(denseOf(*model.body.matrices.mass))
    , viscosity_(denseOf(*model.body.matrices.viscosity))
    , stiffness_(denseOf(*model.body.matrices.stiffness))
{
  for (int dof = 0; dof < model.body.numOwnedDofs(); ++dof) {
    if (!model.body.held[dof]) {
      free_.push_back(dof);
    }
  }
}

DenseReference::Motion DenseReference::motion(double v0, double a0, double jerk0, double v1,
                                              double tau) const
{
  if (scheme_ == Scheme::backward_euler) {
    const double a1 = (v1 - v0) / tau;
    return {tau * v1, a1, (a1 - a0) / tau};
  }
  if (scheme_ == Scheme::newmark) {
    const double beta = parameter_;
    const double a1 = 2 * (v1 - v0) / tau - a0;
    return {tau * v0 + tau * tau * ((0.5 - beta) * a0 + beta * a1), a1, (a1 - a0) / tau};
  }
  // Chung and Hulbert 1993 with alpha_f = 0, the method of Wood, Bossak and Zienkiewicz. Its own
  // acceleration A lags behind a by -alpha_m steps.
  const double rho = parameter_;
  const double alpha_m = (rho - 1) / (rho + 1);
  const double gamma = 0.5 - alpha_m;
  const double beta = (1 - alpha_m) * (1 - alpha_m) / 4;
  const double A0 = a0 + alpha_m * tau * jerk0;
  const double A1 = ((v1 - v0) / tau - (1 - gamma) * A0) / gamma;
  const double a1 = (1 - alpha_m) * A1 + alpha_m * A0;
  return {tau * v0 + tau * tau * ((0.5 - beta) * A0 + beta * A1), a1, (A1 - a1) / (alpha_m * tau)};
}

DenseReference::Motion DenseReference::motion(Step const& step, int dof, double v1) const
{
  return motion(step.from.v[dof], step.from.a[dof], step.from.jerk[dof], v1, step.tau);
}

// mu = a asinh(V / (2 V*) exp((mu* + b alpha) / a)) at the end of the step, with the alpha after
// theta' = 1 - V theta / L over tau at the mean slip rate of the step.
DenseReference::NodalFriction DenseReference::friction(Step const& step, int i, double v1) const
{
  auto const& o = model_.options;
  const double du = motion(step, (*model_.surface)[i].dofs[0], v1).du;
  const double V = model_.surface->slipFactor() * std::abs(du) / step.tau;
  const double theta0 = o.L / o.reference_rate * std::exp(step.from.alpha[i]);
  const double left = std::exp(-V * step.tau / o.L);
  const double theta1 = V > 0 ? theta0 * left + o.L / V * (1 - left) : theta0 + step.tau;
  const double alpha = std::log(theta1 * o.reference_rate / o.L);
  const double mu = o.a * std::asinh(model_.surface->slipFactor() * v1 / (2 * o.reference_rate) *
                                     std::exp((o.reference_friction + o.b * alpha) / o.a));
  const double sign = v1 > 0 ? 1 : -1;
  const double sigma_n = model_.normalStress(model_.surface->vertex(i), step.t1);
  return {(*model_.surface)[i].weight * (sigma_n * mu + o.cohesion * sign), alpha};
}

// M a1 + C v1 + K u1 - l + f at the free dofs for the v1 in `to`, of which it completes the rest.
Eigen::VectorXd DenseReference::imbalance(Step const& step, DenseState& to) const
{
  for (int dof = 0; dof < to.v.size(); ++dof) {
    auto const end = motion(step, dof, to.v[dof]);
    to.u[dof] = step.from.u[dof] + end.du;
    to.a[dof] = end.a;
    to.jerk[dof] = end.jerk;
  }
  Eigen::VectorXd sum = mass_ * to.a + viscosity_ * to.v + stiffness_ * to.u - step.load;
  for (int i = 0; i < model_.surface->numNodes(); ++i) {
    const int dof = (*model_.surface)[i].dofs[0];
    auto const nodal = friction(step, i, to.v[dof]);
    sum[dof] += nodal.force;
    to.alpha[i] = nodal.alpha;
  }
  return sum(free_);
}

Eigen::MatrixXd DenseReference::jacobian(Step const& step, DenseState const& to) const
{
  auto const by_velocity = motion(0, 0, 0, 1, step.tau); // a motion is linear
  Eigen::MatrixXd result = by_velocity.a * mass_ + viscosity_ + by_velocity.du * stiffness_;
  for (int i = 0; i < model_.surface->numNodes(); ++i) {
    const int dof = (*model_.surface)[i].dofs[0];
    const double v = to.v[dof];
    const double h = 1e-6 * std::abs(v);
    result(dof, dof) += (friction(step, i, v + h).force - friction(step, i, v - h).force) / (2 * h);
  }
  return result(free_, free_);
}

DenseState DenseReference::step(DenseState const& from, double t1, double tau) const
{
  auto load = model_.body.vector();
  auto prescribed = model_.body.vector();
  model_.body.load(t1, *load);
  model_.body.prescribed_velocity(t1, *prescribed);
  const Step step = {from, t1, tau, denseOf(*load)};

  DenseState to = from;
  to.v = denseOf(*prescribed);
  to.v(free_) = from.v(free_);
  Eigen::VectorXd rest = imbalance(step, to);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Eigen::VectorXd change = jacobian(step, to).lu().solve(rest);
    // Halved while it leads to a larger imbalance, or across a standstill of the fault.
    DenseState next = to;
    double length = 1;
    for (int halving = 0; halving < 20; ++halving, length /= 2) {
      next.v(free_) = to.v(free_) - length * change;
      const Eigen::VectorXd next_rest = imbalance(step, next);
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
} // namespace asperity::dynamics::test
