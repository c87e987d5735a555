#pragma once

#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Teuchos_ParameterList.hpp>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace asperity::tnnmg
{
namespace detail
{
class MultigridHierarchy;
}

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

// What the corrections of all matrices Z = sum_k w_k A_k with the same terms A_k share: MueLu's
// prolongators, made once, and the terms projected to the coarse levels. A copy shares them, too.
class MultigridTerms
{
public:
  using MatrixSource = std::function<RCP<const CrsMatrix>()>; // collective
  MultigridTerms() = default; // none: a correction makes its own, of Z alone
  // like: near null space, held rows and nodes of the problems to come; its Z is not read. The
  // first term decides the prolongators, and the others have no couplings that it has not; they are
  // made one after the other. Rows and columns of held dofs are diagonal in all terms.
  // Throws SolveError if MueLu's set-up fails.
  MultigridTerms(std::vector<MatrixSource> const& terms, MultigridProblem const& like,
                 Teuchos::ParameterList const& parameters);

  bool empty() const { return !hierarchy_; }
  detail::MultigridHierarchy const& hierarchy() const { return *hierarchy_; } // unless empty

private:
  friend class MultigridCorrection;
  std::shared_ptr<const detail::MultigridHierarchy> hierarchy_;
};

// The linear correction by smoothed aggregation multigrid with MueLu's prolongators: V-cycles, or
// conjugate gradients with a V-cycle as preconditioner, in single precision. Belos solves to
// relative tolerances below 1e-3, on the exact operator; TNNMG's default, 1e-2, does not need it.
class MultigridCorrection final : public LinearCorrection
{
public:
  static RCP<const Teuchos::ParameterList> validParameters();

  // Throws InputError unless MueLu and Belos accept the sublists `MueLu` and `Belos`: a small
  // problem on this rank alone is solved with them. If both are empty, nothing is tried.
  static void requireAccepted(Teuchos::ParameterList const& parameters);

  // Z is the sum of the terms times weights; if terms are empty, Z is the only one. Throws
  // SolveError if MueLu's set-up fails, or if the V-cycle turns out not to be symmetric and
  // positive.
  MultigridCorrection(MultigridProblem const& problem, Teuchos::ParameterList const& parameters,
                      MultigridTerms const& terms = {}, std::vector<double> const& weights = {});
  ~MultigridCorrection() override;

  CorrectionResult solve(NonlinearBlocks const& blocks, Vector const& r, double relative_tolerance,
                         Vector& c) override;
  void reset() override;

  int rebuilds() const;      // how often Hessians were brought into the coarse levels
  std::size_t bytes() const; // of this correction alone, on this rank

  // What a run takes for each unknown, with corrections for three step sizes, as measured
  // (log/performance.md): on large models and on small ones.
  static constexpr std::array<double, 2> usual_bytes_per_unknown = {4.3e3, 6.7e3};

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};
} // namespace asperity::tnnmg
