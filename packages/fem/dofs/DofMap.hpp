#pragma once

#include "base/Types.hpp"

#include <memory>
#include <vector>

namespace asperity
{
class GhostExchange;
}

namespace asperity::fem
{
// Degrees of freedom of a vector field with the same number of components at every vertex.
//
// Locally, dof = vertex * components + component, over owned and ghost vertices alike; the owned
// ones come first. Globally, dof = global vertex id * components + component.
class DofMap
{
public:
  // global_ids(num_local): the owned vertices first, then the ghosts, as in Mesh.
  DofMap(std::vector<GlobalOrdinal> const& global_ids, int num_owned, int components,
         RCP<const Communicator> const& communicator);

  int components() const { return components_; }
  int numOwnedNodes() const { return num_owned_; }
  int numLocalNodes() const { return num_local_; }
  int dof(int node, int component) const { return node * components_ + component; }

  RCP<const Communicator> const& communicator() const { return communicator_; }
  RCP<const Map> const& owned() const { return owned_; }
  RCP<const Map> const& overlap() const { return overlap_; }
  // x_local := the values of x(owned dofs) at owned dofs and ghosts, on overlap(). Collective.
  void shareWithGhosts(MultiVector const& x, MultiVector& x_local) const;

private:
  int components_;
  int num_owned_;
  int num_local_;
  RCP<const Communicator> communicator_;
  RCP<const Map> owned_;
  RCP<const Map> overlap_;
  std::shared_ptr<const GhostExchange> ghosts_; // of dofs
};
} // namespace asperity::fem
