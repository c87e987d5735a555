#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

#include <vector>

namespace asperity::fem
{
// The points of faults at which what flows along them has one value each. A point is a node, or a
// joint: all nodes at one place where faults cross or one ends at another one, each of which has a
// node of its own there. What flows passes from one fault into the other ones at their joints.
class FaultPoints
{
public:
  // point_of_node(num_nodes) < num_points; each point has a node. The nodes of a point have one
  // owner. Collective.
  FaultPoints(std::vector<int> const& point_of_node, int num_points,
              Communicator const& communicator);

  int numPoints() const { return num_points_; } // of this rank
  int operator[](int node) const { return of_node_[node]; }
  GlobalOrdinal numJoints() const { return num_joints_; } // over all ranks

  // (num_points) sums over their nodes of values(num_nodes).
  std::vector<double> sums(std::vector<double> const& values) const;
  // (num_points) means over their nodes of values(num_nodes) by weights(num_nodes) >= 0, one of
  // which is above zero at each point; equal values have the same mean to the last digit.
  std::vector<double> means(std::vector<double> const& values,
                            std::vector<double> const& weights) const;

  // at_points(num_points) := at_nodes(num_nodes), which are equal at the nodes of a point.
  void gather(ConstNodeView const& at_nodes, NodeView const& at_points) const;
  // at_nodes(num_nodes) := at_points(num_points).
  void scatter(ConstNodeView const& at_points, NodeView const& at_nodes) const;

private:
  std::vector<int> of_node_;
  int num_points_;
  GlobalOrdinal num_joints_ = 0;
  IndexView points_of_nodes_; // (num_nodes)
  IndexView first_nodes_;     // (num_points)
};
} // namespace asperity::fem
