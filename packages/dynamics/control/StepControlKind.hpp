#pragma once

#include "dynamics/control/StepControl.hpp"
#include "parameters/Kind.hpp"

namespace asperity::dynamics
{
// Registered under the name of its list in the deck's list `Time Stepping`, at the bottom of the
// file of the control:
//   ASPERITY_REGISTER(StepControlRegistry, "Step Doubling", StepControlKindOf<StepDoubling>)
struct StepControlKind : Kind<StepControl, ControlContext>
{
  static constexpr char const* registered_as = "step control";
};
template <class Control>
using StepControlKindOf = KindOf<StepControlKind, Control>;
using StepControlRegistry = Registry<StepControlKind>;
} // namespace asperity::dynamics
