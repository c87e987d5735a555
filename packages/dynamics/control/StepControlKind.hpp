#pragma once

#include "dynamics/control/StepControl.hpp"
#include "parameters/Kind.hpp"

#include <string>

namespace asperity::dynamics
{
// Registered under the name of its list in the deck's list `Time Stepping`, at the bottom of the
// file of the control:
//   ASPERITY_REGISTER(StepControlRegistry, "Step Doubling", StepControlKindOf<StepDoubling>)
struct StepControlKind : Kind<StepControl, ControlContext>
{
  static constexpr char const* registered_as = "step control";

  // Whether a restart may change this entry of its list: none, unless the class has a static
  // function of the same name.
  virtual bool mayChange(std::string const& entry) const = 0;
  // The entry, a number, with the tolerance of the estimated error of a step, from which the
  // tolerance of the fixed point follows; "" if it has none. A class that has one says so by a
  // static function of the same name.
  virtual std::string toleranceEntry() const = 0;
};

namespace detail
{
template <class Control>
auto mayChange(std::string const& entry, int) -> decltype(Control::mayChange(entry))
{
  return Control::mayChange(entry);
}
template <class Control>
bool mayChange(std::string const&, long)
{
  return false;
}
template <class Control>
auto toleranceEntryOf(int) -> decltype(std::string(Control::toleranceEntry()))
{
  return Control::toleranceEntry();
}
template <class Control>
std::string toleranceEntryOf(long)
{
  return "";
}
} // namespace detail

template <class Control>
struct StepControlKindOf : KindOf<StepControlKind, Control>
{
  bool mayChange(std::string const& entry) const override
  {
    return detail::mayChange<Control>(entry, 0);
  }
  std::string toleranceEntry() const override { return detail::toleranceEntryOf<Control>(0); }
};
using StepControlRegistry = Registry<StepControlKind>;
} // namespace asperity::dynamics
