#pragma once

#include "portability/Views.hpp"

#include <functional>

namespace asperity::dynamics
{
// How the normal stress follows the compression R that the body exerts across the fault:
//   sigma_n = max(floor, sigma_0(x, t) + lambda),   lambda = R - R(start of the run).
enum class NormalStressChange
{
  fixed,  // lambda = 0
  lagged, // lambda at the beginning of the step: first order in the step size
  coupled // lambda at the end of the step, found together with the state of the fault
};

// The law of the normal stress at the nodes of the fault [Pa], positive in compression: sigma_0, a
// constant or a function of time that is never negative, and the way in which the normal stress
// follows the body. The current value is not stored here but in State::sigma_n.
class NormalStress
{
public:
  using Function = std::function<void(double, NodeView const&)>;

  // sigma_0(num_nodes)
  explicit NormalStress(ConstNodeView const& constant);
  // Fills sigma_0(num_nodes) for the time t [s].
  explicit NormalStress(Function at);

  // Returns a copy that follows the body as `change` says and stays above a floor >= 0 [Pa].
  NormalStress following(NormalStressChange change, double floor) const;
  NormalStressChange change() const { return change_; }
  double floor() const { return floor_; }

  bool dependsOnTime() const { return static_cast<bool>(at_); }
  // sigma_0(num_nodes) at the time t [s].
  void at(double t, NodeView const& sigma_0) const;
  // sigma_n(num_nodes) = max(floor, sigma_0 + now - start), where now and start hold R(num_nodes).
  // sigma_n and sigma_0 may be the same view.
  void add(ConstNodeView const& sigma_0, ConstNodeView const& now, ConstNodeView const& start,
           NodeView const& sigma_n) const;
  // sigma_n(num_nodes) = max(floor, sigma_n)
  void raiseToFloor(NodeView const& sigma_n) const;

private:
  ConstNodeView constant_;
  Function at_;
  NormalStressChange change_ = NormalStressChange::fixed;
  double floor_ = 0;
};
} // namespace asperity::dynamics
