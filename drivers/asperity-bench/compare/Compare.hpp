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

// After every accepted step of a three-dimensional deck, solves and times without set-up, each from
// the same guess, which is extrapolated from the last two states:
// 1. one more step of the same size;
// 2. the rate problem of this step, with the state at its end;
// 3. the linear problem with the same Z and solution, by conjugate gradients preconditioned by
//    MueLu's smoothed aggregation with its defaults, until the error in the energy norm is that of
//    2.
// Collective.
Comparison compareWithLinear(asperity::ParameterList const& deck, CompareOptions const& options,
                             asperity::RCP<const asperity::Communicator> const& communicator);

std::string comparisonTable(Comparison const& comparison, int num_ranks);
std::string comparisonJson(Comparison const& comparison, int num_ranks);
