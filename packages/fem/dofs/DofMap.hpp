#pragma once

#include "base/Types.hpp"

#include <vector>

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
  // From owned values to owned and ghost values.
  RCP<const Import> const& ghostImport() const { return ghost_import_; }

private:
  int components_;
  int num_owned_;
  int num_local_;
  RCP<const Communicator> communicator_;
  RCP<const Map> owned_;
  RCP<const Map> overlap_;
  RCP<const Import> ghost_import_;
};
} // namespace asperity::fem
