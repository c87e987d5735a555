#pragma once

#include "friction/Registry.hpp"
#include "unit/friction/Reference.hpp"
#include "unit/friction/Views.hpp"

#include <memory>
#include <vector>

namespace asperity::friction::test
{
// Kernels and states for a list of nodes that all have the law of the first.
struct Fault
{
  explicit Fault(std::vector<ReferenceNode> const& nodes)
  {
    Values weight, sigma_n, cohesion, factor, alphas;
    std::vector<Values> parameters;
    for (auto const& node : nodes) {
      weight.push_back(node.weight);
      sigma_n.push_back(node.sigma_n);
      cohesion.push_back(node.cohesion);
      factor.push_back(node.factor);
      alphas.push_back(node.alpha);
      parameters.push_back(
        {node.law.a, node.law.b, node.law.reference_slip_rate, node.law.reference_friction});
    }
    kernels =
      makeFrictionKernels(nodes.at(0).law.name, {toDevice(weight), toDevice(cohesion),
                                                 toDevice(factor), parametersOf(parameters)});
    alpha = toDevice(alphas);
    at = {alpha, toDevice(sigma_n)};
  }

  std::unique_ptr<FrictionKernels> kernels;
  NodeView alpha;
  StateAndStress at;
};

// Laws, states, cohesion and slip factors that the kernels' tests go through.
inline std::vector<ReferenceNode> variousNodes(std::string const& law)
{
  std::vector<ReferenceNode> nodes;
  for (const double alpha : {-60.0, -30.0, -3.0, 0.0, 7.0, 40.0}) {
    for (const double cohesion : {0.0, 20.0}) {
      for (const double factor : {1.0, 2.0}) {
        nodes.push_back({{law, 0.002, 0.014, 5e-5, 0.7}, 1e-3, 5e3, cohesion, factor, alpha});
        nodes.push_back({{law, 0.010, 0.015, 1e-6, 0.6}, 2e2, 5e7, 1e5 * cohesion, factor, alpha});
      }
    }
  }
  return nodes;
}

inline const std::vector<std::string> both_laws{"Regularised", "Truncated"};
inline const std::vector<double> lengths{0, 1e-300, 1e-20, 1e-6, 1, 1e2}; // m/s

// Direction number k of the plane; of the line for T = 1.
inline Values direction(int T, int k)
{
  const double angle = 0.3 + k;
  return T == 1 ? Values{k % 2 == 0 ? 1.0 : -1.0} : Values{std::cos(angle), std::sin(angle)};
}

inline Values scaled(Values vector, double factor)
{
  for (double& value : vector) {
    value *= factor;
  }
  return vector;
}

inline Vector2 widened(Values const& w)
{
  return {Real(w[0]), w.size() > 1 ? Real(w[1]) : Real(0)};
}
} // namespace asperity::friction::test
