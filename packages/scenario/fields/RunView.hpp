#pragma once

#include "dynamics/condensation/VertexMotion.hpp"
#include "dynamics/control/StepControl.hpp"
#include "dynamics/observables/FaultSample.hpp"
#include "scenario/fields/FloorCount.hpp"

#include <memory>

namespace asperity::scenario
{
// The present state of a run, from which outputs read; the simulation keeps it up to date.
struct RunView
{
  dynamics::State const* state = nullptr;
  dynamics::FaultSample const* fault = nullptr; // of that state
  // Computes the state of the whole body from that of a condensed model; null without condensation.
  dynamics::StaticCondensation const* condensation = nullptr;
  std::shared_ptr<dynamics::RecoveryRows> recovery_rows; // of the condensation, for receivers
  dynamics::EnergyBalance const* balance = nullptr;
  FloorCount const* floor_count = nullptr;
  dynamics::AcceptedStep step;
  dynamics::SolveCount count; // of the last step alone
};
} // namespace asperity::scenario
