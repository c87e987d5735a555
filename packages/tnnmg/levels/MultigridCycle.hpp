#pragma once

#include "tnnmg/detail/MultigridNodes.hpp"
#include "tnnmg/levels/CoarsestSolver.hpp"
#include "tnnmg/levels/MultigridFamily.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace asperity::tnnmg::detail
{
// A V-cycle for Z + H on the dofs that are neither removed nor held: block Gauss-Seidel, forward
// before and backward after the coarse correction, so that the cycle is symmetric. A node's block
// is its block of Z + H. Gauss-Seidel is local to a rank and runs on the host. From zero a forward
// sweep leaves the residual -U x (U the couplings with later nodes and with other ranks), so that
// sweep and residual together read the matrix once.
class MultigridCycle
{
public:
  // Z is the sum of the family's terms times weights, and needed for its fine entries only.
  MultigridCycle(std::shared_ptr<const MultigridFamily> family, std::vector<double> weights,
                 CrsMatrix const& Z, std::shared_ptr<const MultigridNodes> nodes);

  // Takes the fine Hessians and the removed nodes; to be called after the nodes or the coarse
  // Hessians have changed, before run(). Throws SolveError if a matrix is not positive definite.
  // Collective.
  void setup();
  // Brings Hessians into the coarse levels, in place of those before: (num_nodes, T, T) on the
  // host, or empty for none. Collective.
  void setCoarseHessians(std::vector<double> const& hessian);

  // One cycle for (Z + H) z = r that starts from zero, in single precision: r should be of the
  // order of one. z is zero at removed and held dofs, where r is not read. With image, it also
  // computes (Z + H) z, which costs much less than a product, since the backward sweep has most of
  // it. Collective.
  void run(bool with_image) const;
  NodeVector& r() const { return levels_.front().b; }
  NodeVector const& z() const { return levels_.front().x; } // ghosts follow
  NodeVector const& image() const { return levels_.front().residual; }

  std::size_t bytes() const; // of this rank, without the family

private:
  struct Level
  {
    explicit Level(MultigridLevel const& shared);

    NodeBlocks A, inverse;   // inverse of the diagonal blocks, zero where not free
    mutable NodeVector b, x; // x with ghosts
    mutable NodeVector residual;
    mutable NodeVector coarse; // on the columns of the prolongation
    GhostExchange ghosts;
    std::optional<GhostExchange> coarse_ghosts;
  };

  template <int N>
  void smoothForward(std::size_t l) const;
  template <int N>
  void smoothBackward(std::size_t l) const;
  template <int N>
  void addImage() const;
  template <int N>
  void clearHeld(NodeVector& x, Level const& level) const;
  void cycle(std::size_t l) const;
  void sumTerms(std::size_t l, int row);
  void invert(std::size_t l, int row);
  void invertFine(int row, double const* hessian, bool const* removed);
  void factorise(NodeBlocks const& A);
  bool isCoarsest(std::size_t l) const { return l + 1 == levels_.size(); }

  std::shared_ptr<const MultigridFamily> family_;
  std::vector<double> weights_;
  std::shared_ptr<const MultigridNodes> nodes_;
  std::vector<Level> levels_;
  Kokkos::View<const LocalOrdinal**, Kokkos::LayoutRight, Kokkos::HostSpace> fault_; // dofs
  std::vector<char> held_;                                                           // (dofs)
  std::unique_ptr<CoarsestSolver> coarsest_;
};
} // namespace asperity::tnnmg::detail
