#include "tnnmg/FaultColumns.hpp"

#include "portability/Renamed.hpp"
#include "tnnmg/OrderedSums.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>

#include <string>

namespace asperity::tnnmg
{
namespace
{
const std::string label_pack = "asperity::tnnmg::packColumns";
const std::string label_unpack = "asperity::tnnmg::unpackColumns";

template <class Values>
void pack(IndexView const& places, Values const& from, NodeView const& to)
{
  Kokkos::parallel_for(
    label_pack, RangePolicy(0, places.extent(0)),
    KOKKOS_LAMBDA(int i) { to(i) = from(places(i), 0); });
}

template <class Values>
void unpack(NodeView const& from, IndexView const& places, Values const& to)
{
  Kokkos::parallel_for(
    label_unpack, RangePolicy(0, places.extent(0)),
    KOKKOS_LAMBDA(int i) { to(places(i), 0) = from(i); });
}

// Several ranks may have a ghost of the same place, so that places may repeat.
template <class Values>
void subtract(NodeView const& from, IndexView const& places, Values const& to)
{
  detail::addInOrder(
    places.extent_int(0),
    KOKKOS_LAMBDA(int i) { Kokkos::atomic_add(&to(places(i), 0), -from(i)); });
}

// Copies values to the host, exchanges them between the ranks, and copies the result back.
template <class Exchange>
void overHost(NodeView const& from, NodeView const& to, Exchange const& exchange)
{
  auto const sent = toHost(from);
  auto const received = Kokkos::create_mirror_view(to);
  exchange(sent.data(), received.data());
  Kokkos::deep_copy(to, received);
}
} // namespace

FaultColumns::Part::Part(Halo const& of, int num_owned)
    : halo(of)
    , sent(toDevice(of.sent(), "asperity::tnnmg::sentColumns"))
    , sent_values("asperity::tnnmg::sentValues", of.sent().size())
    , received_values("asperity::tnnmg::receivedValues", of.received().size())
{
  auto places = of.received();
  for (int& place : places) {
    place += num_owned;
  }
  received = toDevice(places, "asperity::tnnmg::receivedColumns");
}

void FaultColumns::Part::share(Vector& columns) const
{
  pack(sent, columns.getLocalViewDevice(Tpetra::Access::ReadOnly), sent_values);
  overHost(sent_values, received_values,
           [&](double const* from, double* to) { halo.share(from, to); });
  unpack(received_values, received, columns.getLocalViewDevice(Tpetra::Access::ReadWrite));
}

FaultColumns::FaultColumns(CrsMatrix const& Z, NonlinearNodes const& nodes)
{
  if (Z.getGraph()->getImporter().is_null()) {
    return;
  }
  auto const& owned = *Z.getDomainMap();
  auto const& columns = *Z.getColMap();
  const int num_owned = static_cast<int>(numLocalElements(owned));
  const int num_columns = static_cast<int>(numLocalElements(columns));
  std::vector<GlobalOrdinal> ghosts;
  for (int k = num_owned; k < num_columns; ++k) {
    ghosts.push_back(columns.getGlobalElement(k));
  }
  auto const dofs = toHost(nodes.dofs);
  auto const matrix = Z.getLocalMatrixHost();
  std::vector<char> is_touched(ghosts.size(), 0);
  for (int node = 0; node < nodes.numNodes(); ++node) {
    for (int k = 0; k < nodes.blockSize(); ++k) {
      const int row = dofs(node, k);
      for (auto e = matrix.graph.row_map(row); e < matrix.graph.row_map(row + 1); ++e) {
        if (const int column = matrix.graph.entries(e); column >= num_owned) {
          is_touched[column - num_owned] = 1;
        }
      }
    }
  }
  const Halo touched = Halo(owned, ghosts).withGhosts(is_touched);
  all_ = Part(touched, num_owned);
  for (auto const& colour : nodes.colours) {
    std::vector<char> is_of_colour(num_owned, 0);
    auto const of_colour = toHost(colour);
    for (int i = 0; i < of_colour.extent_int(0); ++i) {
      for (int k = 0; k < nodes.blockSize(); ++k) {
        is_of_colour[dofs(of_colour(i), k)] = 1;
      }
    }
    colours_.emplace_back(touched.withOwned(is_of_colour), num_owned);
  }
}

void FaultColumns::share(Vector& columns) const
{
  if (!colours_.empty()) {
    all_.share(columns);
  }
}

void FaultColumns::shareColour(std::size_t colour, Vector& columns) const
{
  if (!colours_.empty()) {
    colours_[colour].share(columns);
  }
}

void FaultColumns::subtractGhosts(Vector const& columns, Vector& r) const
{
  if (colours_.empty()) {
    return;
  }
  pack(all_.received, columns.getLocalViewDevice(Tpetra::Access::ReadOnly), all_.received_values);
  overHost(all_.received_values, all_.sent_values,
           [&](double const* from, double* to) { all_.halo.gather(from, to); });
  subtract(all_.sent_values, all_.sent, r.getLocalViewDevice(Tpetra::Access::ReadWrite));
}
} // namespace asperity::tnnmg
