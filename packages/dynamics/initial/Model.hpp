#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/State.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/fault/NormalReaction.hpp"

namespace asperity::dynamics
{
// A body, its fault, and where they start: all that the steps of a run depend on.
struct Model
{
  Body body;
  Fault fault;
  State initial;
  ReactionSinceStart reaction; // empty unless the normal stress follows the body
};
} // namespace asperity::dynamics
