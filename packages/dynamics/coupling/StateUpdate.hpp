#pragma once

#include "dynamics/coupling/FaultUnknown.hpp"
#include "dynamics/fault/Fault.hpp"

namespace asperity::dynamics
{
// alpha, which flows with the mean slip rate of the step. A change of the normal stress shifts it
// by -(c / b) d(ln sigma_n) (Linker and Dieterich 1992): half of the shift comes before the flow,
// half after it (Strang 1968), which is of second order.
class StateUpdate final : public FaultUnknown
{
public:
  explicit StateUpdate(Fault const& fault); // which must outlive this

  NodeView const& of(State const& state) const override { return state.alpha; }
  int respond(FaultResponse const& to, NodeView const& image) override;
  bool endsWithImage() const override { return true; }

private:
  Fault const& fault_;
  NodeView shifted_; // alpha before the flow; without entries if nothing shifts it
};
} // namespace asperity::dynamics
