#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

#include <deque>
#include <vector>

namespace asperity::dynamics
{
// Anderson's acceleration of a fixed point iteration x -> g(x) (Anderson 1965; Walker and Ni 2011):
// the next x is the affine combination of the last images g(x) for which the same combination of
// the residuals g(x) - x has the smallest weighted sum of squares. With n weights, x has n values
// or several times as many, n of the first unknown first.
class AndersonAcceleration
{
public:
  // `depth` >= 0 iterates are remembered in addition to the last one; with 0 this is the plain
  // iteration. weights: of this rank's values, of which each counts on one rank.
  AndersonAcceleration(ConstNodeView const& weights, RCP<const Communicator> const& communicator,
                       int depth);

  // Forgets all iterates.
  void reset() { iterates_.clear(); }

  // Replaces x by the next iterate, given image = g(x). Collective.
  void advance(NodeView const& x, ConstNodeView const& image);

private:
  struct Iterate
  {
    NodeView residual, image;
  };

  // The gamma_j in x = g_0 - sum_j gamma_j (g_0 - g_j), where g_0 is the last image and g_j are the
  // earlier ones, in the order of iterates_.
  std::vector<double> coefficients() const;

  ConstNodeView weights_;
  RCP<const Communicator> communicator_;
  std::size_t depth_;
  std::deque<Iterate> iterates_; // the last one first
};
} // namespace asperity::dynamics
