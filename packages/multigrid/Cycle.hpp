#pragma once

#include "multigrid/Hierarchy.hpp"
#include "multigrid/Smoother.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::multigrid
{
class CoarsestSolver;
struct SumTermsRow; // CycleKernels.hpp
template <int N>
struct InvertRow;
template <int N>
struct InvertFinest;

// A V-cycle for Z + H on the dofs that are neither removed nor held, with a Smoother before and
// after the coarse correction, so that the cycle is symmetric. H has blocks at some nodes, the
// added nodes. It runs where all kernels do; the coarsest level is solved on the host.
class Cycle
{
public:
  // Z: the sum of the hierarchy's terms times weights on the finest level, at most most_terms, or
  // std::invalid_argument is thrown.
  // held(rows): 1 or 0. added(num_nodes, T): local rows of the added nodes, T <= 3. smoother: a
  // name of SmootherRegistry. Collective.
  static constexpr char const* usual_smoother = "Gauss-Seidel";
  static constexpr int most_terms = 16;
  using Dofs = Kokkos::View<const int**, Kokkos::LayoutRight, MemorySpace>;
  Cycle(std::shared_ptr<const Hierarchy> hierarchy, std::vector<double> const& weights,
        HostBlocks const& Z, std::vector<char> const& held, Dofs const& added,
        std::string const& smoother = usual_smoother);
  ~Cycle();

  // Takes H(num_nodes, T, T) and the removed(num_nodes) nodes among the added ones, 1 or 0; to be
  // called after these or the coarse blocks have changed, before run(). False on all ranks if the
  // coarsest matrix is not positive definite. Collective.
  [[nodiscard]] bool setup(HessianView const& H, ConstFlagView const& removed);
  // Brings blocks (num_nodes, T, T) into the coarse levels, in place of those before. Collective.
  void setCoarseBlocks(HessianView const& H);

  // Both are overwritten by the next cycle.
  struct Result
  {
    NodeVector z;     // ghosts follow
    NodeVector image; // (Z + H) z at free dofs, zero at others, if it is wanted
  };
  // One cycle for (Z + H) z = r that starts from zero, in single precision: r should be of the
  // order of one. z is zero at removed and held dofs, where r is not read. With Gauss-Seidel the
  // image costs much less than a product, since the backward sweep has most of it. All vectors are
  // in the order of the finest level's rows. Collective.
  Result run(NodeVector const& r, bool with_image);

  // To that order, divided by `by`, and from it, times `times`.
  void toRows(ConstNodeView const& given, double by, NodeVector const& x) const;
  void fromRows(NodeVector const& x, double times, NodeView const& result) const;

  std::size_t rows() const { return finest().graph.rows(); } // of r
  int rowSize() const { return finest().graph.row_size; }
  Schedule const& schedule() const { return finest().schedule; } // of its rows
  std::size_t bytes() const; // of this rank, without the hierarchy

private:
  struct LevelData
  {
    LevelData(Level const& level, SumOverRanks sum);

    LevelMatrix matrix;                 // of Z + H
    std::unique_ptr<Smoother> smoother; // null on the coarsest level
    NodeVector b, x;                    // x with ghosts; no b on the finest level
    NodeVector residual;
    NodeVector coarse;             // on the columns of the prolongation
    std::vector<NodeVector> parts; // of what chunks restrict to the next level
  };

  Level const& finest() const { return hierarchy_->levels().front(); }
  bool isCoarsest(std::size_t l) const { return l + 1 == data_.size(); }
  SumTermsRow sumOfTerms(std::size_t l) const;
  template <int N>
  InvertRow<N> inversion(std::size_t l) const;
  void damp(std::size_t l);
  void clearHeld(std::size_t l, NodeVector const& x) const;
  template <int N>
  InvertFinest<N> finestInversion() const;
  void descend(std::size_t l, NodeVector const& b);
  bool factorise(NodeBlocks const& A);

  std::shared_ptr<const Hierarchy> hierarchy_;
  std::vector<double> weights_;
  std::vector<LevelData> data_;
  Dofs added_;                               // rows of the finest level
  NodeBlocks own_;                           // (added nodes, N, N) their blocks of Z alone
  std::unique_ptr<CoarsestSolver> coarsest_; // null until setup()
};
} // namespace asperity::multigrid
