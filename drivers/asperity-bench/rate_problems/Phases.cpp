#include "rate_problems/Phases.hpp"

#include "rate_problems/FrictionForces.hpp"
#include "scenario/setup/NodalField.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace asperity;

namespace
{
constexpr double background = 1e-3; // slip rate over V*

std::vector<double> atFaultNodes(scenario::Problem<3> const& problem, ParameterList const& friction,
                                 char const* name)
{
  return scenario::nodalValues(friction, name, "Asperity / Friction", problem.mesh,
                               problem.surface->vertices());
}

Point<3> overRanks(Communicator const& communicator, Teuchos::EReductionType kind, Point<3> mine)
{
  Point<3> all = mine;
  Teuchos::reduceAll(communicator, kind, 3, mine.data(), all.data());
  return all;
}

// The box around the part of the fault where friction weakens, and the fault's normal.
struct WeakeningZone
{
  Point<3> centre, half, normal{};

  WeakeningZone(scenario::Problem<3> const& problem, ParameterList const& friction)
  {
    auto const a = atFaultNodes(problem, friction, "a");
    auto const b = atFaultNodes(problem, friction, "b");
    const double far = std::numeric_limits<double>::max();
    Point<3> low = {far, far, far}, high = {-far, -far, -far}, sum{};
    for (std::size_t i = 0; i < a.size(); ++i) {
      auto const& node = (*problem.surface)[static_cast<int>(i)];
      auto const& x = node.place;
      for (int d = 0; d < 3; ++d) {
        sum[d] += node.weight * node.normal[d];
        if (b[i] > a[i]) {
          low[d] = std::min(low[d], x[d]);
          high[d] = std::max(high[d], x[d]);
        }
      }
    }
    low = overRanks(*problem.communicator, Teuchos::REDUCE_MIN, low);
    high = overRanks(*problem.communicator, Teuchos::REDUCE_MAX, high);
    sum = overRanks(*problem.communicator, Teuchos::REDUCE_SUM, sum);
    const double length = std::hypot(sum[0], sum[1], sum[2]);
    for (int d = 0; d < 3; ++d) {
      centre[d] = (low[d] + high[d]) / 2;
      half[d] = (high[d] - low[d]) / 2;
      normal[d] = sum[d] / length;
    }
  }

  // The depth of a point in the body, and the distance of its projection onto the fault from the
  // centre of the zone, in half lengths of the longest side of the zone.
  double depth(Point<3> const& x) const
  {
    double across = 0;
    for (int d = 0; d < 3; ++d) {
      across -= (x[d] - centre[d]) * normal[d];
    }
    return std::max(across, 0.);
  }
  double distance(Point<3> const& x) const
  {
    const double across = depth(x);
    Point<3> along;
    for (int d = 0; d < 3; ++d) {
      along[d] = x[d] + across * normal[d] - centre[d];
    }
    return std::hypot(along[0], along[1], along[2]) / size();
  }
  double size() const { return std::max({half[0], half[1], half[2]}); }
};

double slipRate(Phase phase, double distance, double slow, double fast)
{
  switch (phase) {
  case Phase::stuck: return slow;
  case Phase::nucleating: {
    const double peak = std::log(0.01 * fast / slow);
    return slow * std::exp(peak * std::exp(-std::pow(distance / 0.5, 2)));
  }
  case Phase::rupturing: {
    const double behind = std::min(1., std::max(0., (1 - distance) / 0.8));
    return slow * std::exp(std::log(fast / slow) * behind);
  }
  }
  return slow;
}

// The direction of slip: x, projected onto the fault.
Point<3> slipDirection(Point<3> const& normal)
{
  Point<3> direction = {1 - normal[0] * normal[0], -normal[0] * normal[1], -normal[0] * normal[2]};
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  for (double& component : direction) {
    component /= length;
  }
  return direction;
}

} // namespace

char const* nameOf(Phase phase)
{
  return phase == Phase::stuck ? "stuck" : phase == Phase::nucleating ? "nucleating" : "rupturing";
}

KnownProblem makeKnownProblem(scenario::Problem<3> const& problem, ParameterList const& friction,
                              Phase phase, double rupture_rate, dynamics::RateUpdate const& update,
                              double tau)
{
  const WeakeningZone zone(problem, friction);
  auto const reference = friction.get<double>("Reference Slip Rate");
  auto const direction = slipDirection(zone.normal);
  auto const& body = problem.body;
  auto const rateAt = [&](Point<3> const& x) {
    return slipRate(phase, zone.distance(x), background * reference, rupture_rate);
  };
  KnownProblem known = {body.vector(), body.vector(), {}};
  {
    auto const values = known.v->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < problem.mesh.num_owned; ++node) {
      auto const& x = problem.mesh.vertices[node];
      const double speed = rateAt(x) * std::exp(-zone.depth(x) / zone.size());
      Point<3> along_axes, local;
      for (int d = 0; d < 3; ++d) {
        along_axes[d] = speed / problem.surface->slipFactor() * direction[d];
      }
      problem.constraints->frames().toFrame(node, along_axes.data(), local.data());
      for (int c = 0; c < 3; ++c) {
        values(body.dofs->dof(node, c), 0) = local[c];
      }
    }
  }
  body.clearHeld(*known.v);
  std::vector<double> alpha;
  for (auto const& node : *problem.surface) {
    alpha.push_back(std::log(reference / rateAt(node.place)));
  }
  known.alpha = toDevice(alpha, "asperity::bench::alpha");
  auto const& matrices = body.matrices;
  matrices.mass->apply(*known.v, *known.b, Teuchos::NO_TRANS, update.mass_weight / tau, 0);
  matrices.viscosity->apply(*known.v, *known.b, Teuchos::NO_TRANS, 1, 1);
  matrices.stiffness->apply(*known.v, *known.b, Teuchos::NO_TRANS, tau * update.stiffness_weight,
                            1);
  addFrictionForces(*problem.surface,
                    {problem.fault.friction(), {known.alpha, problem.initial.sigma_n}}, *known.v,
                    *known.b);
  body.clearHeld(*known.b);
  return known;
}
