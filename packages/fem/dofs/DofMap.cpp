#include "fem/dofs/DofMap.hpp"

#include "base/parallel/GhostExchange.hpp"
#include "portability/Renamed.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <utility>

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

std::vector<GlobalOrdinal> ghostsOf(Map const& owned, Map const& overlap)
{
  std::vector<GlobalOrdinal> ghosts;
  for (auto k = numLocalElements(owned); k < numLocalElements(overlap); ++k) {
    ghosts.push_back(overlap.getGlobalElement(static_cast<LocalOrdinal>(k)));
  }
  return ghosts;
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
    , ghosts_(std::make_shared<const GhostExchange>(*owned_, ghostsOf(*owned_, *overlap_)))
{
}

void DofMap::shareWithGhosts(MultiVector const& x, MultiVector& x_local) const
{
  auto const from = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const to = x_local.getLocalViewDevice(Tpetra::Access::OverwriteAll);
  for (std::size_t column = 0; column < from.extent(1); ++column) {
    const NodeView values(to.extent(0) > 0 ? &to(0, column) : nullptr, to.extent(0));
    Kokkos::deep_copy(Kokkos::subview(values, std::make_pair(std::size_t(0), from.extent(0))),
                      Kokkos::subview(from, Kokkos::ALL, column));
    ghosts_->share<double>(values);
  }
}
} // namespace asperity::fem
