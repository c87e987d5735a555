#pragma once

#include "multigrid/Hierarchy.hpp"

#include <Kokkos_Core.hpp>

#include <memory>
#include <vector>

namespace asperity::multigrid
{
template <class Data>
using HostView = Kokkos::View<Data, Kokkos::LayoutRight, Kokkos::HostSpace>;

class CoarsestSolver;

// A V-cycle for Z + H on the dofs that are neither removed nor held: block Gauss-Seidel, forward
// before and backward after the coarse correction, so that the cycle is symmetric. A node's block
// is its block of Z + H, where H has blocks at some nodes, the added nodes. It runs on the host, on
// all its threads; between chunks of rows and between ranks Gauss-Seidel is Jacobi (Sweeps). From
// zero a forward sweep leaves the residual of the couplings that it has not used, so that sweep and
// residual together read the matrix once.
class Cycle
{
public:
  // Z: the sum of the hierarchy's terms times weights on the finest level. held(rows): 1 or 0.
  // added(num_nodes, T): local rows of the added nodes, T <= 3.
  Cycle(std::shared_ptr<const Hierarchy> hierarchy, std::vector<double> weights, NodeBlocks Z,
        std::vector<char> held, HostView<const int**> added);
  ~Cycle();

  // Takes H(num_nodes, T, T) and the removed(num_nodes) nodes among the added ones, 1 or 0; to be
  // called after these or the coarse blocks have changed, before run(). False on all ranks if the
  // coarsest matrix is not positive definite. Collective.
  [[nodiscard]] bool setup(HostView<const double***> const& H, HostView<const int*> const& removed);
  // Brings blocks (num_nodes, T, T) into the coarse levels, in place of those before. Collective.
  void setCoarseBlocks(std::vector<double> const& H);

  // Both are overwritten by the next cycle.
  struct Result
  {
    NodeVector const& z;     // ghosts follow
    NodeVector const& image; // (Z + H) z, if it is wanted
  };
  // One cycle for (Z + H) z = r that starts from zero, in single precision: r should be of the
  // order of one. z is zero at removed and held dofs, where r is not read. The image costs much
  // less than a product, since the backward sweep has most of it. Collective.
  Result run(NodeVector const& r, bool with_image);

  std::size_t rows() const { return hierarchy_->levels.front().graph.rows(); } // of r
  int rowSize() const { return hierarchy_->levels.front().graph.row_size; }
  Chunks const& chunks() const { return hierarchy_->levels.front().chunks; } // of its rows
  std::size_t bytes() const; // of this rank, without the hierarchy

private:
  struct LevelData
  {
    explicit LevelData(Level const& level);

    NodeBlocks A, inverse; // inverse of the diagonal blocks, zero where not free
    NodeVector b, x;       // x with ghosts; no b on the finest level
    NodeVector residual;
    NodeVector coarse;             // on the columns of the prolongation
    NodeVector before;             // x before a sweep of several chunks
    std::vector<NodeVector> parts; // of what chunks restrict to the next level
  };

  void descend(std::size_t l, NodeVector const& b);
  void sumTerms(std::size_t l, int row);
  void invert(std::size_t l, int row);
  void invertFinest(int row, double const* H, bool const* removed);
  bool factorise(NodeBlocks const& A);
  bool isCoarsest(std::size_t l) const { return l + 1 == data_.size(); }

  std::shared_ptr<const Hierarchy> hierarchy_;
  std::vector<double> weights_;
  std::vector<LevelData> data_;
  HostView<const int**> added_;              // dofs
  std::vector<char> held_;                   // (dofs)
  std::unique_ptr<CoarsestSolver> coarsest_; // null until setup()
};
} // namespace asperity::multigrid
