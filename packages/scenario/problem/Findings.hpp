#pragma once

#include "base/Warning.hpp"
#include "dynamics/initial/Model.hpp"
#include "scenario/problem/LoadedBody.hpp"
#include "scenario/problem/SetupContext.hpp"
#include "scenario/problem/StaticStart.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// What a user should know about a problem before it runs.
struct Findings
{
  std::vector<std::string> remarks;
  std::vector<Warning> warnings;
  double largest_slip_rate; // [m/s] that is plausible, dynamics::largestSlipRate
};

// of_stress: warnings about the normal stress. Collective.
template <int Dim>
Findings findingsOf(SetupContext<Dim> const& context, dynamics::Model const& model,
                    ShearTraction const& traction, StaticStart const& start,
                    std::vector<Warning> const& of_stress);
} // namespace asperity::scenario
