#pragma once

#include "base/Types.hpp"
#include "friction/FrictionKernels.hpp"
#include "friction/StateKernels.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace asperity::dynamics
{
enum class Norm
{
  root_mean_square, // over the fault
  maximum
};

// The fault nodes of this rank and what happens at them.
struct Fault
{
  std::vector<std::vector<int>> dofs; // (num_nodes, T) local dofs of the tangential components
  // (num_nodes, T) 1 where the velocity is prescribed. Beside a free component it has to be zero,
  // since friction knows the direction of slip only then: requireWalls.
  std::vector<std::vector<int>> fixed;
  int num_tangents = 1;   // T
  double slip_factor = 1; // slip = slip_factor times the tangential displacement
  friction::FaultData data;
  double total_weight = 0; // over all ranks: the measure of the fault
  // Where the normal stress changes: what fills it [Pa] at the time t [s], and the memory that
  // data.sigma_n shows. Empty where it does not change.
  std::function<void(double, friction::NodeView const&)> normal_stress_at;
  friction::NodeView normal_stress;
  RCP<const Communicator> communicator;
  std::unique_ptr<friction::FrictionKernels> friction;
  std::unique_ptr<friction::StateKernels> state;

  int sumOverRanks(int value) const;
  int numNodes() const { return static_cast<int>(dofs.size()); }
  // Whether friction decides on the velocity of a node, or on a part of it.
  bool slides(int node) const;
  // InputError unless the prescribed velocity (owned dofs, `components` for each vertex) is zero at
  // fixed components beside free ones. t [s] for the message.
  void requireWalls(Vector const& prescribed_velocity, int components, double t) const;
  // Tangential components of v at the fault nodes.
  void gather(Vector const& v, friction::BlockView const& blocks) const;
  // Slip rates |v| slip_factor of tangential velocities v. Views over the nodes.
  void slipRate(friction::ConstBlockView const& v, friction::NodeView const& V) const;
  // What acts on the fault at the time t [s], from now on.
  void setTime(double t) const;
  // Largest slip rate over all ranks, where it is not prescribed.
  double peakSlipRate(Vector const& v) const;
  // Of a - b over the fault, over all ranks.
  double distance(friction::ConstNodeView const& a, friction::ConstNodeView const& b,
                  Norm norm = Norm::root_mean_square) const;
};
} // namespace asperity::dynamics
