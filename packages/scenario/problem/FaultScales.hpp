#pragma once

#include "dynamics/checks/FaultResolution.hpp"
#include "dynamics/checks/FrontZone.hpp"
#include "dynamics/fault/Fault.hpp"
#include "portability/Views.hpp"
#include "scenario/problem/SetupContext.hpp"
#include "scenario/setup/friction/LawsAtNodes.hpp"

#include <optional>
#include <vector>

namespace asperity::scenario
{
// The zone behind the front of slip that the state at the start lets expect.
struct ExpectedFront
{
  double rate;          // [m/s] of the front
  double cells, length; // FrontZone::Narrowest
};

// Lengths and slip rates that follow from friction, rock and normal stress at the start.
struct FaultScales
{
  // How well the mesh resolves ruptures. Empty if friction weakens nowhere that can slip, or if the
  // laws do not declare a, b and L; then the rates are 0 and `weakening` is empty.
  std::optional<dynamics::FaultResolution> resolution;
  // (num fault nodes) L where friction weakens with the slip rate [m], 0 elsewhere; empty if the
  // part that weakens is so short that it creeps. For dynamics::SlowSlip.
  std::vector<double> weakening;
  double barrier = 0; // the share of the fault that cannot slip under the loads, by its measure
  // Given where the zone behind the front is far narrower than the cohesive zone, or where there is
  // no cohesive zone.
  std::optional<ExpectedFront> front;
  // That zone, which is watched during the run; empty without `front`, and where laws weaken
  // friction at high slip rates, whose fronts are seismic.
  std::optional<dynamics::FrontZone> zone;

  double slipDistance() const; // L, smallest [m]; 0 if unknown
  double slowRate() const;     // a tenth of a seismic slip rate [m/s]
  double waveRate() const;     // dynamics::WaveScale::slip_rate [m/s]
};

// The scales of a fault with these laws, in its state at the start. driving(num fault nodes): the
// largest shear traction of the loads [Pa]. Collective.
template <int Dim>
FaultScales faultScales(SetupContext<Dim> const& context, LawsAtNodes const& laws,
                        dynamics::Fault const& fault, dynamics::State const& initial,
                        std::vector<double> const& driving);
} // namespace asperity::scenario
