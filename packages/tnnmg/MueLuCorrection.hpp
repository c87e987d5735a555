#pragma once

#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>

namespace asperity::tnnmg
{
// The effort of a multigrid correction since it was made.
struct MultigridStatistics
{
  int solves = 0;
  int iterations = 0; // of conjugate gradients, or V-cycles if they are used alone
  int v_cycles = 0;   // of the solves

  int setups = 0;           // whole hierarchies
  int rebuilds = 0;         // Galerkin products with kept prolongators
  double setup_seconds = 0; // for both and for the tests of a new hierarchy, on this rank
};

// What multigrid needs to know about Z in addition to its entries. All vectors live on Z's row map.
struct MultigridProblem
{
  RCP<const CrsMatrix> Z; // symmetric positive definite, dof = node * components + component
  int components = 0;     // displacement components per node
  // Rigid body motions in the dofs' frames: 1 antiplane, 3 in 2D, 6 in 3D.
  RCP<const MultiVector> near_null_space;
  IndexView held_rows;  // rows of held dofs: their off-diagonal entries in Z are zero
  NonlinearNodes nodes; // the same T for all
};

// The linear correction by smoothed aggregation multigrid (MueLu): V-cycles, or conjugate gradients
// (Belos) on the exact operator with a V-cycle as preconditioner. One hierarchy per Z, made by the
// constructor.
class MueLuCorrection final : public LinearCorrection
{
public:
  static RCP<const Teuchos::ParameterList> validParameters();

  // Throws InputError unless MueLu and Belos accept the sublists `MueLu` and `Belos`: a small
  // problem on this rank alone is solved with them. If both are empty, nothing is tried.
  static void requireAccepted(Teuchos::ParameterList const& parameters);

  // Throws SolveError if MueLu's set-up fails, or if the V-cycle turns out not to be symmetric (a
  // broken coarse solver or smoother).
  MueLuCorrection(MultigridProblem const& problem, Teuchos::ParameterList const& parameters);
  ~MueLuCorrection() override;

  CorrectionResult solve(NonlinearBlocks const& blocks, Vector const& r, double relative_tolerance,
                         Vector& c) override;
  void reset() override;

  MultigridStatistics statistics() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace asperity::tnnmg
