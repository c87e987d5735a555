#include "scaling/Scaling.hpp"

#include "base/parallel/Reductions.hpp"
#include "measuring/Meters.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <Tpetra_Vector.hpp>

using namespace asperity;

namespace
{
SolveSample solve(scenario::Problem<3> const& problem, KnownProblem const& known,
                  dynamics::RateSolver& solver)
{
  auto const zero = problem.body.vector();
  auto const v = problem.body.vector();
  const dynamics::FrictionProblem nodal{problem.fault.friction(),
                                        {known.alpha, problem.initial.sigma_n}};
  SolveSample sample;
  const Stopwatch watch;
  solver.begin(*known.b, *zero);
  auto const result = solver.solve(nodal);
  solver.velocity(*v);
  sample.seconds = watch.seconds();
  sample.iterations = result.iterations;
  sample.corrections = result.corrections;
  sample.v_cycles = result.v_cycles;
  sample.converged = result.converged;
  v->update(-1, *known.v, 1);
  sample.error = v->normInf() / known.v->normInf();
  return sample;
}
} // namespace

MeshSample measureMesh(ParameterList const& deck, ScalingOptions const& options, double cell_size,
                       RCP<const Communicator> const& communicator)
{
  MeshSample sample;
  sample.cell_size = cell_size;
  const Stopwatch watch;
  auto const problem = scenario::makeProblem<3>(deck, communicator);
  sample.build_seconds = watch.seconds();
  sample.num_unknowns = problem.mesh.num_global_vertices * problem.components;
  sample.num_fault_nodes = problem.surface->numGlobalNodes();
  sample.product_seconds = productSeconds(problem.body);
  auto const update = scenario::makeRateUpdate(deck.sublist("Time Stepping"), true);
  for (double tau : options.steps) {
    const dynamics::DyadicTime clock(tau, 0);
    dynamics::StepSolvers solvers(problem.body, *problem.surface, update, clock, problem.solver, 0);
    auto& solver = solvers.at(0);
    for (Phase phase : phases) {
      auto const known = makeKnownProblem(problem, deck.sublist("Friction"), phase,
                                          options.rupture_rate, update, tau);
      auto of_phase = solve(problem, known, solver);
      of_phase.phase = phase;
      of_phase.tau = tau;
      of_phase.setup_seconds = solvers.setupSeconds();
      sample.solves.push_back(of_phase);
    }
  }
  sample.peak_bytes = sumOverRanks(peakBytes(), *communicator);
  return sample;
}
