#pragma once

#include "registry/LawParameters.hpp"

namespace asperity::friction
{
using asperity::infinity;
using asperity::no_default;
using asperity::Parameter;
using asperity::ParameterOf;
using asperity::Range;

// Parameters that several laws have.
namespace parameter
{
// The slip rate that the direct effect and the evolution of the state refer to.
inline constexpr Parameter reference_slip_rate{
  "Reference Slip Rate", "m/s", 1e-6, Range::positive(),
  "At this slip rate V* friction in steady sliding has the reference coefficient."};

inline constexpr Parameter reference_friction{
  "Reference Friction Coefficient", "-", 0.6, Range::atLeast(0),
  "Friction has this coefficient mu* in steady sliding at the reference slip rate."};

inline constexpr Parameter direct_effect{
  "a",
  "-",
  no_default,
  Range::positive(),
  "This is the weight of the direct effect: mu grows by this value when the slip rate grows by "
  "a factor e.",
  "Check the sign; typical values are 0.005 to 0.03."};

// b of a friction law, where it may be zero.
inline constexpr Parameter state_effect{
  "b", "-", no_default, Range::atLeast(0),
  "This is the weight of the state: mu grows by this value when the state theta grows by a "
  "factor e."};

// b of a state law that divides by it.
inline constexpr Parameter positive_state_effect{state_effect.name, state_effect.unit,
                                                 state_effect.default_value, Range::positive(),
                                                 state_effect.meaning};

inline constexpr Parameter slip_distance{
  "L", "m", no_default, Range::positive(),
  "This is the characteristic slip distance, over which the state adapts to a new slip rate."};
} // namespace parameter
} // namespace asperity::friction
