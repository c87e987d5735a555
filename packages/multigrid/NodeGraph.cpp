#include "multigrid/NodeGraph.hpp"

#include <algorithm>
#include <map>

namespace asperity::multigrid
{
namespace
{
// to(i) = from(first + places(i))
struct Pack
{
  IndexView places;
  std::size_t first;
  NodeVector from, to;
  KOKKOS_FUNCTION void operator()(int i) const { to(i) = from(first + places(i)); }
};

// to(first + places(i)) = from(i)
struct Unpack
{
  IndexView places;
  std::size_t first;
  NodeVector from, to;
  KOKKOS_FUNCTION void operator()(int i) const { to(first + places(i)) = from(i); }
};

// What other ranks have is added in the order of messages.
struct AddToOwners
{
  IndexView owners, first, places;
  NodeVector from, to;
  KOKKOS_FUNCTION void operator()(int i) const
  {
    for (int k = first(i); k < first(i + 1); ++k) {
      to(owners(i)) += from(places(k));
    }
  }
};

template <class Kernel>
void overList(IndexView const& list, Kernel const& kernel)
{
  Kokkos::parallel_for("asperity::multigrid::ghosts", RangePolicy(0, list.extent_int(0)), kernel);
}
} // namespace

int HostGraph::find(int row, int column) const
{
  auto const begin = columns.begin() + first[row], end = columns.begin() + first[row + 1];
  auto const place = std::lower_bound(begin, end, column);
  return place != end && *place == column ? static_cast<int>(place - columns.begin()) : -1;
}

Ghosts::Ghosts(GhostMessages const& messages, std::size_t first)
    : messages_{{}, {}, messages.share, messages.gather}
    , first_(first)
    , sent_(onDevice(messages.sent))
    , received_(onDevice(messages.received))
    , sent_values_(makeNumbers(messages.sent.size()))
    , received_values_(makeNumbers(messages.received.size()))
    , sent_on_host_(Kokkos::create_mirror_view(Kokkos::HostSpace(), sent_values_))
    , received_on_host_(Kokkos::create_mirror_view(Kokkos::HostSpace(), received_values_))
{
  std::map<int, std::vector<int>> places;
  for (std::size_t i = 0; i < messages.sent.size(); ++i) {
    places[messages.sent[i]].push_back(static_cast<int>(i));
  }
  std::vector<int> owners, begins = {0}, all;
  for (auto const& [owner, of_owner] : places) {
    owners.push_back(owner);
    all.insert(all.end(), of_owner.begin(), of_owner.end());
    begins.push_back(static_cast<int>(all.size()));
  }
  owners_ = onDevice(owners);
  first_place_ = onDevice(begins);
  places_ = onDevice(all);
}

void Ghosts::share(NodeVector const& x) const
{
  overList(sent_, Pack{sent_, 0, x, sent_values_});
  Kokkos::deep_copy(sent_on_host_, sent_values_);
  messages_.share(sent_on_host_.data(), received_on_host_.data());
  Kokkos::deep_copy(received_values_, received_on_host_);
  overList(received_, Unpack{received_, first_, received_values_, x});
}

void Ghosts::gather(NodeVector const& x) const
{
  overList(received_, Pack{received_, first_, x, received_values_});
  Kokkos::deep_copy(received_on_host_, received_values_);
  messages_.gather(received_on_host_.data(), sent_on_host_.data());
  Kokkos::deep_copy(sent_values_, sent_on_host_);
  overList(owners_, AddToOwners{owners_, first_place_, places_, sent_values_, x});
}

NodeGraph::NodeGraph(HostGraph const& host)
    : GraphSizes(host)
    , first(onDevice(host.first))
    , columns(onDevice(host.columns))
{
  if (host.ghosts.share) {
    ghosts = std::make_shared<const Ghosts>(host.ghosts, static_cast<std::size_t>(host.num_owned) *
                                                           host.column_size);
  }
}

void NodeGraph::share(NodeVector const& x) const
{
  if (ghosts) {
    ghosts->share(x);
  }
}

void NodeGraph::gather(NodeVector const& x) const
{
  if (ghosts) {
    ghosts->gather(x);
  }
}
} // namespace asperity::multigrid
