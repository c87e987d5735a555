#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/rate/FrictionProblem.hpp"
#include "fem/FaultSurface.hpp"
#include "tnnmg/Tnnmg.hpp"
#include "tnnmg/correction/MultigridCorrection.hpp"
#include "tnnmg/direct/EliminationOrder.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <vector>

namespace asperity::dynamics
{
// How the linear correction of TNNMG is found; packages/tnnmg/README.md compares the two.
enum class Correction
{
  // Sparse Cholesky factorisation of Z, then TNNMG on the Schur complement on the fault; one rank.
  direct,
  multigrid
};

struct RateSolverSettings
{
  tnnmg::TnnmgSettings tnnmg;
  Correction correction = Correction::direct;
  Teuchos::ParameterList multigrid; // of MultigridCorrection, completed
};

// Solves rate problems (Pipping 2014, problem 4.2) with one matrix Z and one right side, but
// changing states:
//   w = argmin 1/2 <Z w, w> - <b, w> + sum of psi_i(w_i, alpha_i), w = 0 at held dofs.
// psi has the unknowns of the surface: FrictionProblem, or OpeningProblem if that may open.
class RateSolver
{
public:
  virtual ~RateSolver() = default;

  // Sets a new right side (zero at held dofs) and a first guess for w.
  virtual void begin(Vector const& b, Vector const& guess) = 0;
  // Solves a rate problem, starting from the last answer.
  virtual tnnmg::TnnmgResult solve(tnnmg::NodalProblem const& problem) = 0;
  // Makes one iteration of TNNMG from the last answer.
  virtual tnnmg::TnnmgResult improve(tnnmg::NodalProblem const& problem) = 0;
  // The last answer w: at the fault nodes, the tangential components (num_nodes, T) or all that
  // the surface has unknowns, and at all owned dofs.
  virtual void faultVelocity(BlockView const& w) const = 0;
  virtual void velocity(Vector& w) const = 0;
  // The same at those dofs alone where it is known without further work, the fault's at least.
  virtual void knownVelocity(Vector& w) const = 0;
  // r = N w of the last answer, for this rank's rows of the N that the solver was made with.
  virtual void reactions(NodeView const& r) const = 0;
  virtual std::size_t bytes() const = 0; // estimated memory on this rank
};

// What solvers of the same body with other Z have made already, and what a new solver reuses.
struct SharedSetup
{
  tnnmg::MultigridTerms terms; // of the levels; none with the direct correction
  std::vector<double> weights; // of the terms in this Z
  tnnmg::EliminationOrder* order =
    nullptr; // of the direct correction; null: the solver makes its own
};

// The rows of held dofs in Z must have their diagonal entries only. reactions: the matrix N (any
// number of rows, owned dofs) of linear functionals of w that are needed after every iteration, or
// null.
std::unique_ptr<RateSolver> makeRateSolver(RCP<const CrsMatrix> const& Z, Body const& body,
                                           fem::FaultSurface const& surface,
                                           RateSolverSettings const& settings,
                                           RCP<const CrsMatrix> const& reactions = Teuchos::null,
                                           SharedSetup const& shared = {});
} // namespace asperity::dynamics
