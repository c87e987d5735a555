#pragma once

#include "base/Views.hpp"
#include "fem/OtherSide.hpp"
#include "fem/constraints/Constraints.hpp"
#include "fem/constraints/HeldDofs.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::fem
{
// One node of a fault, on the rank that owns it.
struct FaultNode
{
  // Local vertices of the mesh that lie at this node: one where the fault is a boundary of the
  // body, two (+, -) where it lies between two bodies, four where another fault crosses it: its
  // own (+, -) on the minus side of the other one, then those on its plus side, (-, +). Where a
  // branch ends at it with a joint, the vertex of that follows. The first vertex carries the
  // unknowns.
  std::vector<int> copies;
  std::array<double, 3> place{};  // [m]; z = 0 in two dimensions
  std::array<double, 3> normal{}; // unit, out of the body, which lies on the plus side
  double weight = 0;              // integral of the node's basis function [m^(Dim-1)]
  std::vector<int> dofs;          // (T) local dofs of the tangential unknowns
  std::vector<std::array<double, 3>> tangents = {}; // (T) along the axes, unit vectors
  // Whether it lies on a fault whose slip is prescribed.
  bool has_given_slip = false;
  // On a surface that may open: the local dof of the jump across, and what it is multiplied with to
  // give the opening, 1 or -1.
  int across = -1;
  double opening_sign = 1;
};

// The one description of a fault's nodes: places, copies, weights, dofs, what is held, colours, and
// the map from unknowns to slip, plate rate included. It is made once and never changes; friction,
// the solver and the outputs have views of it, all in the order of its nodes.
class FaultSurface
{
public:
  // colours as of colourFreeNodes. Collective.
  FaultSurface(std::string name, std::vector<FaultNode> nodes, int num_tangents, HeldDofs held,
               std::vector<IndexView> colours, OtherSide const& other_side,
               RCP<const Communicator> const& communicator);

  std::string const& name() const { return name_; } // of the boundary in the mesh
  int numNodes() const { return static_cast<int>(nodes_.size()); }
  int numTangents() const { return num_tangents_; } // T
  GlobalOrdinal numGlobalNodes() const { return num_global_nodes_; }
  double totalWeight() const { return total_weight_; } // the measure of the fault, over all ranks
  OtherSide const& otherSide() const { return other_side_; }
  double slipFactor() const { return other_side_.slip_factor; }
  RCP<const Communicator> const& communicator() const { return communicator_; }

  FaultNode const& operator[](int node) const { return nodes_[node]; }
  auto begin() const { return nodes_.begin(); }
  auto end() const { return nodes_.end(); }

  // The same fault under back slip, where plates move along it at Vp(num_nodes, T) [m/s], constant
  // in time: the slip rate is factor v_t + Vp, and the body moves at v alone.
  std::shared_ptr<const FaultSurface> withPlateRate(std::vector<double> const& rates) const;
  bool hasPlateRate() const { return has_plate_rate_; } // the same on all ranks
  double plateRate(int node, int k) const               // [m/s]
  {
    return has_plate_rate_ ? plate_rate_[node * num_tangents_ + k] : 0;
  }

  // The vertex that carries the unknowns of a node.
  int vertex(int node) const { return nodes_[node].copies.front(); }
  std::vector<int> vertices() const; // (num_nodes), ascending
  int nodeAt(int vertex) const;      // -1 if this rank has no node there
  // Whether the velocity of a local dof, or of tangential component k, is prescribed.
  bool isHeld(int dof) const { return held_[dof]; }
  bool held(int node, int k) const { return held_[nodes_[node].dofs[k]]; }
  // Whether at least one tangential velocity of the node is not prescribed, so that friction acts.
  bool slides(int node) const;
  // How many nodes slide, over all ranks. Without any the slip of the fault is known, and each rate
  // problem is linear.
  GlobalOrdinal numSliding() const { return num_sliding_; }
  // Whether the sides may part, somewhere on the surface.
  bool mayOpen() const { return other_side_.may_open; }
  // Whether they may part at the node.
  bool opens(int node) const { return mayOpen() && !held_[nodes_[node].across]; }
  // Local dofs of the unknowns of a node in rate problems: the tangential ones and, where the
  // surface may open, that across.
  std::vector<int> unknownsOf(int node) const;
  int numUnknowns() const { return num_tangents_ + (mayOpen() ? 1 : 0); } // U, of each node
  // Whether the slip at the node counts as that of the fault, in its peak slip rate and moment: the
  // node slides, or lies on a fault whose slip is prescribed. What is prescribed beside friction,
  // where the fault ends at a wall or goes on at a given rate, does not count.
  bool counts(int node) const { return slides(node) || nodes_[node].has_given_slip; }

  // On the device.
  NodeDofView dofs() const { return dofs_; }         // (num_nodes, T)
  NodeDofView unknowns() const { return unknowns_; } // (num_nodes, U)
  // (num_nodes), without entries if the surface cannot open: whether the node may, the dof across,
  // and the sign of the opening there.
  ConstFlagView openingNodes() const { return opening_; }
  IndexView dofsAcross() const { return across_; }
  ConstNodeView openingSigns() const { return opening_signs_; }
  ConstFlagView heldDofs() const { return held_.flagsOnDevice(); }   // (num local dofs)
  std::vector<IndexView> const& colours() const { return colours_; } // of nodes with a free unknown
  ConstFlagView slidingNodes() const { return sliding_; }            // (num_nodes): see slides()
  ConstFlagView countedNodes() const { return counted_; }            // (num_nodes): see counts()
  ConstNodeView weights() const { return weights_; }
  ConstNodeView plateRates() const // (num_nodes T), empty without one
  {
    return plate_rates_;
  }
  ConstNodeView slipFactors() const { return slip_factors_; }

private:
  std::string name_;
  std::vector<FaultNode> nodes_;
  int num_tangents_;
  HeldDofs held_;
  std::vector<IndexView> colours_;
  OtherSide other_side_;
  bool has_plate_rate_ = false;
  std::vector<double> plate_rate_; // (num_nodes, T), empty without one
  RCP<const Communicator> communicator_;
  GlobalOrdinal num_global_nodes_ = 0, num_sliding_ = 0;
  double total_weight_ = 0;
  NodeDofView dofs_, unknowns_;
  ConstFlagView opening_;
  IndexView across_;
  ConstNodeView opening_signs_;
  ConstFlagView sliding_, counted_;
  ConstNodeView weights_, slip_factors_;
  ConstNodeView plate_rates_; // (num_nodes T), empty without one
};

// load += traction(num_nodes, T) [Pa] times each node's share of the fault.
void addTraction(FaultSurface const& surface, std::vector<double> const& traction, Vector& load);

// The fault on a boundary of the body, or on the plus side of a fault inside it. graph: of the
// body's matrices, by which the nodes are coloured. given_slip: boundaries in it whose slip is
// prescribed. A surface without a name has no nodes: that of a body without a fault. Collective.
template <int Dim>
std::shared_ptr<const FaultSurface>
makeFaultSurface(Mesh<Dim> const& mesh, std::string const& boundary,
                 Constraints<Dim> const& constraints, DofMap const& dofs, CrsGraph const& graph,
                 OtherSide const& other_side, Boundaries const& given_slip = {});
} // namespace asperity::fem
