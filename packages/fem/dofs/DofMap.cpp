#include "fem/dofs/DofMap.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>

namespace asperity::fem
{
namespace
{
RCP<const Map> mapOfNodes(std::vector<GlobalOrdinal> const& global_ids, int num_nodes,
                          int components, RCP<const Communicator> const& communicator)
{
  std::vector<GlobalOrdinal> dofs;
  dofs.reserve(static_cast<std::size_t>(num_nodes) * components);
  for (int node = 0; node < num_nodes; ++node) {
    for (int c = 0; c < components; ++c) {
      dofs.push_back(global_ids[node] * components + c);
    }
  }
  auto const unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return rcp(new Map(unknown, Teuchos::arrayViewFromVector(dofs), 0, communicator));
}
} // namespace

DofMap::DofMap(std::vector<GlobalOrdinal> const& global_ids, int num_owned, int components,
               RCP<const Communicator> const& communicator)
    : components_(components)
    , num_owned_(num_owned)
    , num_local_(static_cast<int>(global_ids.size()))
    , communicator_(communicator)
    , owned_(mapOfNodes(global_ids, num_owned_, components, communicator))
    , overlap_(mapOfNodes(global_ids, num_local_, components, communicator))
    , ghost_import_(rcp(new Import(owned_, overlap_)))
{
}
} // namespace asperity::fem
