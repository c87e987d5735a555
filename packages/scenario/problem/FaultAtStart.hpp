#pragma once

#include "base/Warning.hpp"
#include "dynamics/fault/Fault.hpp"
#include "scenario/problem/SetupContext.hpp"
#include "scenario/setup/friction/LawsAtNodes.hpp"

#include <vector>

namespace asperity::scenario
{
// The fault with its laws, under the normal stress at the start.
struct FaultAtStart
{
  dynamics::Fault fault;
  LawsAtNodes laws;
  std::vector<Warning> warnings; // about the normal stress
};

// The laws and processes of the deck's list `Friction` with their parameters at the nodes, and the
// normal stress sigma_n = factor max(values, 0), where factor is `Normal Stress Factor` and the
// values are the deck's `Normal Stress` if it is given, else static_stress(num_nodes) [Pa], that of
// the static solution: a warning says where and how much it is tensile. The stress follows the body
// as `Normal Stress Change` says, where the body presses across the fault.
//
// Throws InputError if the deck's normal stress is negative at t = 0 (values that become negative
// later count as zero), and where the term of Linker and Dieterich (c > 0) is used with a normal
// stress that is or may become zero. Collective.
template <int Dim>
FaultAtStart makeFault(SetupContext<Dim> const& context, std::vector<double> const& static_stress);
} // namespace asperity::scenario
