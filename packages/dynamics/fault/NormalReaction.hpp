#pragma once

#include "dynamics/Body.hpp"
#include "fem/FaultSurface.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "portability/Views.hpp"

#include <memory>
#include <vector>

namespace asperity::dynamics
{
// The compression R that a moving body exerts across its fault. At node i the component across the
// fault is held by the reaction r_i = [M a + C v + K u - l]_i:
//   R_i = -(outward normal) . r_i / support_i [Pa], positive in compression.
// The outward normal (FaultNode::normal) is that of the body; between two bodies, of the one on the
// plus side. R_i = 0 where friction does not decide on the motion of the node and that cannot open.
// Where a fault may open, r_i is the force across that an open fault has to bear. Fault nodes are
// in the order of the surface.
class NormalReaction
{
public:
  // support(num_nodes): what a reaction is spread over, see fem::supportWeights. The component
  // across the fault must be held at each node that slides and cannot open.
  NormalReaction(Body const& body, fem::FaultSurface const& surface, fem::NodalFrames const& frames,
                 std::vector<double> const& support);
  // The same reaction in another body, whose dofs across the fault are these (num_nodes).
  NormalReaction(NormalReaction const& other, Body const& body, std::vector<int> const& dofs);

  std::vector<int> const& dofs() const { return dofs_; } // across the fault, (num_nodes)

  // R(num_nodes) [Pa] of a motion under the load l(owned dofs). Collective.
  void compression(Vector const& l, Motion const& motion, NodeView const& R) const;

  // The rows of a sum of the body's matrices at the components across the fault, without the
  // columns of held dofs: (num_nodes, owned dofs). Collective.
  RCP<const CrsMatrix> rows(fem::Weights const& weights) const;
  // r(num_nodes): the entries of x(owned dofs) at the components across the fault.
  void gather(Vector const& x, NodeView const& r) const;
  // R(num_nodes) of the reactions r(num_nodes), which may be the same view.
  void compression(ConstNodeView const& r, NodeView const& R) const;
  // b(owned dofs) += the forces of a stress(num_nodes) [Pa] that presses the sides together.
  void addCompression(ConstNodeView const& stress, Vector& b) const;

private:
  Body body_;
  RCP<const Map> map_; // of the rows
  std::vector<int> dofs_;
  IndexView dofs_on_device_;
  ConstNodeView per_force_; // R_i / r_i
};

// The reaction across the fault of a run, and R at the start of the run; both are empty for a model
// whose normal stress does not follow the body.
struct ReactionSinceStart
{
  std::shared_ptr<const NormalReaction> reaction = {};
  ConstNodeView at_start = {}; // R(num_nodes) [Pa]
};

// start: at t = 0. Collective.
ReactionSinceStart reactionSince(Motion const& start, Body const& body,
                                 std::shared_ptr<const NormalReaction> const& reaction);
} // namespace asperity::dynamics
