#pragma once

#include "base/Types.hpp"
#include "base/parameters/Parameters.hpp"

#include <string>

struct CompareOptions
{
  int num_steps = 0; // accepted steps
};

// Means over coupled steps of one kind, each with its rate problem and a linear one.
struct ComparedSteps
{
  int count = 0;
  double coupled_seconds = 0, rate_seconds = 0, linear_seconds = 0; // CPU time, sums
  long long coupled_iterations = 0, rate_iterations = 0;            // of TNNMG
  long long coupled_cycles = 0, rate_cycles = 0, linear_cycles = 0; // V-cycles
  double worst_error = 0; // of a rate problem's velocity in the energy norm, relative
};

struct Comparison
{
  long long num_unknowns = 0;
  double product_seconds = 0; // of one product with K: CPU time
  ComparedSteps inertial, quasi_static;
};

// After every accepted step of a three-dimensional deck one more step of its size is solved from a
// guess that the last two states give. Then its rate problem with the state that it ended with is
// solved from the same guess, and last the linear problem with the same Z, solution and guess, by
// conjugate gradients preconditioned by MueLu's smoothed aggregation (its defaults), until its
// error in the energy norm is that of the rate problem's answer. Without set-up. Collective.
Comparison compareWithLinear(asperity::ParameterList const& deck, CompareOptions const& options,
                             asperity::RCP<const asperity::Communicator> const& communicator);

std::string comparisonTable(Comparison const& comparison, int num_ranks);
std::string comparisonJson(Comparison const& comparison, int num_ranks);
