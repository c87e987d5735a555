#pragma once

#include "dynamics/checks/FaultResolution.hpp"
#include "parameters/Parameters.hpp"
#include "portability/Views.hpp"
#include "scenario/setup/NodalField.hpp"

#include <optional>
#include <vector>

namespace asperity::scenario
{
// Lengths and slip rates that follow from friction, rock and normal stress at the start.
struct FaultScales
{
  // How well the mesh resolves ruptures. Empty if friction weakens nowhere, or if the laws do not
  // declare a, b and L; then the rates are 0 and `weakening` is empty.
  std::optional<dynamics::FaultResolution> resolution;
  // (num fault nodes) L where friction weakens with the slip rate [m], 0 elsewhere; empty if the
  // part that weakens is so short that it creeps. For dynamics::SlowSlip.
  std::vector<double> weakening;

  double slipDistance() const; // L, smallest [m]; 0 if unknown
  double slowRate() const;     // a tenth of a seismic slip rate [m/s]
  double waveRate() const;     // dynamics::WaveScale::slip_rate [m/s]
};

// materials: of the body beside the nodes. Collective.
template <int Dim>
FaultScales faultScales(Mesh<Dim> const& mesh, fem::FaultSurface const& surface, int components,
                        std::vector<fem::Material> const& materials, ParameterList const& friction,
                        FieldNodes const& nodes, ConstNodeView const& sigma_n);
} // namespace asperity::scenario
