#pragma once

#include "base/parameters/Parameters.hpp"
#include "dynamics/coupling/CoupledStep.hpp"
#include "measuring/MessageCounts.hpp"

#include <map>
#include <string>

struct StepsOptions
{
  int num_steps = 0; // accepted steps
};

// What the accepted steps of one kind cost, with the steps that were tried on the way.
struct StepsSample
{
  int accepted = 0;
  double smallest = 0, largest = 0; // step size tau, s
  asperity::dynamics::SolveCount count;
  long long products = 0;   // of sparse matrices with vectors, without the V-cycles' own
  double seconds = 0;       // CPU time of this rank, without set-up
  double setup_seconds = 0; // of step sizes
};

// A stretch of a run, see Stretch.
struct StretchSample
{
  long long num_unknowns = 0;
  double product_seconds = 0; // of one product with K: CPU time, the mean over the stretch
  double peak_bytes = 0;      // over all ranks
  int setups = 0;             // of step sizes
  StepsSample inertial, quasi_static;
  // In the steps, set-up of step sizes included, by the kind of work; the largest of the ranks.
  MessageCounts messages;
};

// Runs a three-dimensional deck from its beginning, without outputs. Collective.
StretchSample measureSteps(asperity::ParameterList const& deck, StepsOptions const& options,
                           asperity::RCP<const asperity::Communicator> const& communicator);

std::string stepsTable(StretchSample const& sample, int num_ranks);
std::string stepsJson(StretchSample const& sample, int num_ranks);
