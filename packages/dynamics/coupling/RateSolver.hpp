#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/coupling/FrictionProblem.hpp"
#include "fem/FaultSurface.hpp"
#include "tnnmg/Tnnmg.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <vector>

namespace asperity::dynamics
{
// How the linear correction of TNNMG is found; see README.md.
enum class Correction
{
  // Sparse Cholesky of Z, the friction Hessian by the Schur complement on the fault; one rank.
  direct,
  multigrid
};

struct RateSolverSettings
{
  tnnmg::TnnmgSettings tnnmg;
  Correction correction = Correction::direct;
  Teuchos::ParameterList multigrid; // of MueLuCorrection, completed
};

// Solves rate problems (Pipping 2014, problem 4.2) with one matrix Z and one right side, but
// changing states:
//   w = argmin 1/2 <Z w, w> - <b, w> + sum of psi_i(w_i, alpha_i), w = 0 at held dofs.
class RateSolver
{
public:
  virtual ~RateSolver() = default;

  // A new right side (zero at held dofs), and a first guess for w.
  virtual void begin(Vector const& b, Vector const& guess) = 0;
  // Goes on from the last answer.
  virtual tnnmg::TnnmgResult solve(FrictionProblem const& problem) = 0;
  // The same, by one iteration of TNNMG.
  virtual tnnmg::TnnmgResult improve(FrictionProblem const& problem) = 0;
  // Of the last answer: at the fault nodes, and everywhere.
  virtual void faultVelocity(friction::BlockView const& w) const = 0;
  virtual void velocity(Vector& w) const = 0;
  // N w (rows of N on this rank) of the last answer, with the rows N that the solver was made with.
  virtual std::vector<double> reactions() const = 0;
  virtual std::size_t bytes() const = 0; // on this rank, about
};

// Z with the rows of held dofs replaced by their diagonal entry. reactions: linear functionals N
// (any number of rows, owned dofs) of w that are wanted after every iteration, if any.
std::unique_ptr<RateSolver> makeRateSolver(RCP<const CrsMatrix> const& Z, Body const& body,
                                           fem::FaultSurface const& surface,
                                           RateSolverSettings const& settings,
                                           RCP<const CrsMatrix> const& reactions = Teuchos::null);

// x = Z^-1 b without friction, to 1e-12 of |b| with multigrid. SolveError if that fails.
void solveLinear(RCP<const CrsMatrix> const& Z, Body const& body,
                 RateSolverSettings const& settings, Vector const& b, Vector& x);
} // namespace asperity::dynamics
