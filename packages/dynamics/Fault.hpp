#pragma once

#include "base/Types.hpp"
#include "friction/FrictionKernels.hpp"
#include "friction/StateKernels.hpp"

#include <memory>
#include <vector>

namespace asperity::dynamics
{
// The fault nodes of this rank and what happens at them.
struct Fault
{
  std::vector<std::vector<int>> dofs; // (num_nodes, T) local dofs of the tangential components
  std::vector<int> fixed;             // (num_nodes) 1 where the tangential velocity is prescribed
  int num_tangents = 1;               // T
  double slip_factor = 1;             // slip = slip_factor times the tangential displacement
  friction::FaultData data;
  double total_weight = 0; // over all ranks: the measure of the fault
  RCP<const Communicator> communicator;
  std::unique_ptr<friction::FrictionKernels> friction;
  std::unique_ptr<friction::StateKernels> state;

  int sumOverRanks(int value) const;
  int numNodes() const { return static_cast<int>(dofs.size()); }
  // Tangential components of v at the fault nodes.
  void gather(Vector const& v, friction::BlockView const& blocks) const;
  // Slip rates |lambda v0 + (1 - lambda) v1| slip_factor, thesis eq. (25). Views over the nodes.
  void slipRate(friction::ConstBlockView const& v0, friction::ConstBlockView const& v1,
                double lambda, friction::NodeView const& V) const;
  // Largest slip rate over all ranks.
  double peakSlipRate(Vector const& v) const;
  // Root mean square of a - b over the fault, over all ranks.
  double distance(friction::ConstNodeView const& a, friction::ConstNodeView const& b) const;
};
} // namespace asperity::dynamics
