#pragma once

#include "multigrid/Hierarchy.hpp"
#include "registry/Registry.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace asperity::multigrid
{
// The matrix A of one level as a smoother takes it. Components that are not free, those of held and
// removed dofs among them, have zero rows and columns in `inverse`; in what a smoother gives them
// x = 0, and their residual is not read. D has the blocks of nodes with themselves.
struct LevelMatrix
{
  Level const& level;
  NodeBlocks A;       // of the level's couplings
  NodeVector damping; // (rows) the diagonal E >= 0, which Smoother::damp sets; empty: E is zero
  NodeBlocks inverse; // (nodes, N, N) of D + E at free components
  FlagView held;      // (rows) 1 or 0; empty on coarse levels
  SumOverRanks sum;   // over all ranks, each of which has each level

  int blockSize() const { return level.graph.row_size; }
};

// A smoother S for A x = b on one level, before and after the correction by the coarser levels. The
// cycle is symmetric if the sweep after the correction is the transpose of that before, and
// positive if S + S^T - S A S^T is, that is, if the sweep alone contracts in the energy norm. To
// let sweeps share what they read of A, a smoother computes a residual and a product as well.
// Vectors `x` have the level's columns with ghosts, others its rows. All calls are collective.
class Smoother
{
public:
  Smoother() = default;
  virtual ~Smoother() = default;
  Smoother(Smoother const&) = delete;
  Smoother& operator=(Smoother const&) = delete;

  // Called in this order when A has changed. What is found for the finest level's matrix without
  // added blocks has to hold with them, too: they are positive semidefinite blocks in D.
  virtual void damp(LevelMatrix& /*matrix*/) {}                // sets E, before blocks are inverted
  virtual void matrixChanged(LevelMatrix const& /*matrix*/) {} // blocks are inverted
  // On the finest level added blocks have changed, in A and in the inverses, or the removed nodes.
  virtual void addedBlocksChanged(LevelMatrix const& /*matrix*/) {}

  // x = S b, in place of what x had, and the residual b - A x.
  virtual void presmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                         NodeVector const& residual) = 0;
  // x += S^T (b - A x); ghosts of x need not follow before or after. Overwrites the residual, with
  // anything that image() needs.
  virtual void postsmooth(LevelMatrix const& matrix, NodeVector const& b, NodeVector const& x,
                          NodeVector const& residual) = 0;
  // A x after postsmooth(), in place of what that left in `image`. Ghosts of x follow.
  virtual void image(LevelMatrix const& matrix, NodeVector const& x, NodeVector const& image) = 0;

  virtual std::size_t bytes() const { return 0; } // of its own
};

// Registered at the bottom of the smoother's file under the deck's word:
//   ASPERITY_REGISTER(SmootherRegistry, "Chebyshev", SmootherKindOf<Chebyshev>)
struct SmootherKind
{
  static constexpr char const* registered_as = "smoother";
  SmootherKind() = default;
  virtual ~SmootherKind() = default;
  SmootherKind(SmootherKind const&) = delete;
  SmootherKind& operator=(SmootherKind const&) = delete;

  virtual std::string meaning() const = 0;            // a sentence for the list of parameters
  virtual std::unique_ptr<Smoother> make() const = 0; // for one level
};
// SmootherType::meaning is its sentence.
template <class SmootherType>
struct SmootherKindOf final : SmootherKind
{
  std::string meaning() const override { return SmootherType::meaning; }
  std::unique_ptr<Smoother> make() const override { return std::make_unique<SmootherType>(); }
};
using SmootherRegistry = Registry<SmootherKind>;
} // namespace asperity::multigrid
