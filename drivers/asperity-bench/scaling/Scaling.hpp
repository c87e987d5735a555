#pragma once

#include "base/parameters/Parameters.hpp"
#include "rate_problems/Phases.hpp"

#include <string>
#include <vector>

// One rate problem, solved from rest.
struct SolveSample
{
  Phase phase;
  double tau = 0; // step size, s
  int iterations = 0;
  int corrections = 0;
  int v_cycles = 0;
  double setup_seconds = 0; // of the matrix and the solver of this step size
  double seconds = 0;       // of the solve alone
  bool converged = false;
  double error = 0; // of v, largest component over the largest of the solution
};

// One mesh.
struct MeshSample
{
  long long num_unknowns = 0;
  long long num_fault_nodes = 0;
  double cell_size = 0;       // the value given to the deck
  double build_seconds = 0;   // mesh, matrices, loads
  double product_seconds = 0; // of one product with the stiffness matrix
  double peak_bytes = 0;      // over all ranks, since the program started
  std::vector<SolveSample> solves;
};

struct ScalingOptions
{
  std::string cell_size = "Mesh/Deep Wedge/Cell Size"; // the deck's parameter that is varied
  std::vector<double> sizes;                           // its values, from coarse to fine
  std::vector<double> steps;                           // tau, s
  double rupture_rate = 0.01;                          // m/s
};

// Rate problems of the three phases with each step size on one mesh; the solver of one step size is
// freed before the next one is set up. Collective.
MeshSample measureMesh(asperity::ParameterList const& deck, ScalingOptions const& options,
                       double cell_size,
                       asperity::RCP<const asperity::Communicator> const& communicator);

// Prints a table to read, and the same numbers as JSON.
std::string scalingTable(std::vector<MeshSample> const& samples, int num_ranks);
std::string scalingJson(std::vector<MeshSample> const& samples, int num_ranks);
