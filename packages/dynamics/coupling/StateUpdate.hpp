#pragma once

#include "dynamics/coupling/StepUnknown.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/fault/FrictionInput.hpp"

namespace asperity::dynamics
{
// alpha, which flows with the mean slip rate of the step. A change of the normal stress shifts it
// by -(c / b) d(ln sigma_n) (Linker and Dieterich 1992): half of the shift comes before the flow,
// half after it (Strang 1968), which is of second order.
//
// The iteration ends with a defect d = (image of alpha) - (alpha of the rate problem), by which
// friction is off in this step. Defects of many steps have the same sign, and so would shift the
// time at which a slow nucleation becomes an earthquake. Friction of the next step therefore takes
// alpha + d. The shifts of friction then add up to the last d alone, over any number of steps, and
// the tolerance of the fixed point has little weight in a sequence.
class StateUpdate final : public StepUnknown
{
public:
  explicit StateUpdate(Fault const& fault); // which must outlive this

  NodeView valuesIn(State const& state) const override { return state.alpha; }
  void begin(StepStart const& start) override;
  int respond(StepIterate const& step, NodeView const& image) override;
  bool endsWithImage() const override { return true; }
  void finish(ConstNodeView const& image, State const& to) const override;

private:
  int flow(StepIterate const& step, NodeView const& image);

  Fault const& fault_;
  FrictionInput before_, after_; // of the step
  NodeView carried_; // the defect of the step before, in the iterates and images of this one
  NodeView shifted_; // alpha before the flow; without entries if nothing shifts it
};
} // namespace asperity::dynamics
