#pragma once

#include "dynamics/fault/Fault.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::dynamics
{
enum class AlphaAtStart
{
  given,
  steady,
  stress_balance
};

// What decides on alpha at the start, at the nodes of a fault.
struct GivenAtStart
{
  std::vector<double> given_alpha; // (num_nodes)
  std::vector<double> traction;    // (num_nodes, T) that drives the body along the tangents [Pa]
  ConstNodeView sigma_n;           // (num_nodes) [Pa]
  ConstBlockView w;                // (num_nodes, T) of gatherSlip [m/s]
};

// alpha(num_nodes) at the start:
//   given           given_alpha
//   steady          d(alpha)/dt = 0 at the slip rate V
//   stress_balance  sigma_n mu(V, alpha) + cohesion + eta V = traction (along the velocity)
// Where the velocity is prescribed and the slip rate is zero, friction is never evaluated and alpha
// is given_alpha. Throws InputError if there is no such state at a node; where(node) begins the
// message.
NodeView initialAlpha(Fault const& fault, AlphaAtStart kind, GivenAtStart const& start,
                      std::function<std::string(int)> const& where);
} // namespace asperity::dynamics
