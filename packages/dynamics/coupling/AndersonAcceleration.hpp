#pragma once

#include "fem/FaultSurface.hpp"
#include "portability/Views.hpp"

#include <deque>
#include <vector>

namespace asperity::dynamics
{
// Anderson's acceleration of a fixed point iteration x -> g(x) for the state of a fault (Anderson
// 1965; Walker and Ni 2011): the next x is the affine combination of the last images g(x) for which
// the same combination of the residuals g(x) - x has the smallest mean square over the fault. x has
// one value at each node, or several: (num_unknowns * num_nodes), all nodes of the first unknown
// first.
class AndersonAcceleration
{
public:
  // `depth` >= 0 iterates are remembered beside the last one; with 0 this is the plain iteration.
  AndersonAcceleration(fem::FaultSurface const& surface, int depth);

  // Forgets all iterates.
  void reset() { iterates_.clear(); }

  // Replaces x by the next iterate, given image = g(x). Collective.
  void advance(NodeView const& x, ConstNodeView const& image);

private:
  struct Iterate
  {
    NodeView residual, image;
  };

  // The weights w_j in x = g_0 - sum_j w_j (g_0 - g_j), where g_0 is the last image and g_j are the
  // earlier ones, in the order of iterates_.
  std::vector<double> weights() const;

  fem::FaultSurface const& surface_;
  std::size_t depth_;
  std::deque<Iterate> iterates_; // the last one first
};
} // namespace asperity::dynamics
