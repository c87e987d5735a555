#pragma once

#include "fem/FaultSurface.hpp"
#include "friction/Types.hpp"

#include <deque>
#include <vector>

namespace asperity::dynamics
{
// Anderson's acceleration of a fixed point iteration x -> g(x) for the state of a fault (Anderson
// 1965; Walker and Ni 2011): of all affine combinations of the last iterates, that one is mapped
// next whose residual g(x) - x has the smallest mean square over the fault. x has one value at each
// node, or several: (num_unknowns * num_nodes), all nodes of the first unknown first.
class AndersonAcceleration
{
public:
  // `depth` >= 0 iterates are remembered beside the last one; with 0 this is the plain iteration.
  AndersonAcceleration(fem::FaultSurface const& surface, int depth);

  // Forgets all iterates.
  void reset() { iterates_.clear(); }

  // Replaces x by what should be mapped next, given image = g(x). All ranks together.
  void advance(friction::NodeView const& x, friction::ConstNodeView const& image);

private:
  struct Iterate
  {
    friction::NodeView residual, image;
  };

  // Of each remembered iterate, in the order of iterates_ after its first: how much of its
  // difference from the first is taken out.
  std::vector<double> weights() const;

  fem::FaultSurface const& surface_;
  std::size_t depth_;
  std::deque<Iterate> iterates_; // the last one first
};
} // namespace asperity::dynamics
