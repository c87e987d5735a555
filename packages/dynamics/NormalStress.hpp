#pragma once

#include "friction/Types.hpp"

#include <functional>

namespace asperity::dynamics
{
// The normal stress at the nodes of the fault [Pa], positive in compression, never negative: a
// constant, or a function of time. It is an argument of a step (State::sigma_n) and nothing that
// the fault remembers.
class NormalStress
{
public:
  using Function = std::function<void(double, friction::NodeView const&)>;

  // constant(num_nodes)
  explicit NormalStress(friction::ConstNodeView const& constant);
  // Fills (num_nodes) for the time t [s].
  explicit NormalStress(Function at);

  bool changes() const { return static_cast<bool>(at_); }
  // sigma_n(num_nodes) at the time t [s].
  void at(double t, friction::NodeView const& sigma_n) const;

private:
  friction::ConstNodeView constant_;
  Function at_;
};
} // namespace asperity::dynamics
