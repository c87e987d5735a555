#pragma once

#include "dynamics/RateUpdate.hpp"
#include "scenario/Problem.hpp"

#include <string>
#include <vector>

// States of a fault that occur in an earthquake cycle, chosen such that the solution of a rate
// problem is known. Iteration counts can agree only between meshes that all resolve the state, so
// patch and front are as wide as the zone allows: if cells are a tenth of the zone's half length,
// the slip rate changes by at most two thirds of an order of magnitude from node to node.
enum class Phase
{
  stuck,      // the slip rate is V* / 1000 everywhere
  nucleating, // a smooth patch half as long as the zone slips at up to 1 % of the rupture rate
  rupturing   // the middle of the zone slips at the rupture rate, a wide front reaches its ends
};

constexpr Phase phases[] = {Phase::stuck, Phase::nucleating, Phase::rupturing};
char const* nameOf(Phase phase);

// A rate problem with its solution v: friction in steady state at v, alpha = ln(V* / V), and the
// right side b = Z v + gradient of friction. v points along x projected onto the fault and decays
// into the body.
struct KnownProblem
{
  asperity::RCP<asperity::Vector> v, b; // owned dofs
  asperity::friction::NodeView alpha;   // (num fault nodes)
};

// Z = (mass_weight / tau) M + C + tau stiffness_weight K of problem.body, a plane fault, the deck's
// list `Friction`; rupture_rate in m/s. Collective.
KnownProblem makeKnownProblem(asperity::scenario::Problem<3> const& problem,
                              asperity::ParameterList const& friction, Phase phase,
                              double rupture_rate, asperity::dynamics::RateUpdate const& update,
                              double tau);
