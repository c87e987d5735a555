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
    , sent_(indices(messages.sent))
    , received_(indices(messages.received))
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
  owners_ = indices(owners);
  first_place_ = indices(begins);
  places_ = indices(all);
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

DeviceGraph::DeviceGraph(HostGraph const& host, std::vector<int> const& columns_in_order)
    : GraphSizes(host)
    , columns(indices(columns_in_order))
{
  if (host.ghosts.share) {
    ghosts = std::make_shared<const Ghosts>(host.ghosts, static_cast<std::size_t>(host.num_owned) *
                                                           host.column_size);
  }
}

NodeGraph::NodeGraph(HostGraph const& host)
    : DeviceGraph(host, host.columns)
    , first(indices(host.first))
{
}

namespace
{
// Where the three parts of a matrix have the couplings of each row.
struct Parts
{
  std::vector<int> lower = {0}, upper, diagonal;

  explicit Parts(HostGraph const& host)
  {
    int num_diagonal = 0;
    for (int row = 0; row < host.num_rows; ++row) {
      const auto begin = host.columns.begin() + host.first[row];
      const auto end = host.columns.begin() + host.first[row + 1];
      const auto own = std::lower_bound(begin, end, row);
      const bool has_own = own != end && *own == row;
      lower.push_back(lower.back() + static_cast<int>(own - begin));
      diagonal.push_back(has_own ? num_diagonal++ : -1);
    }
    for (int& own : diagonal) {
      own += own >= 0 ? lower.back() : 0;
    }
    upper = {lower.back() + num_diagonal};
    for (int row = 0; row < host.num_rows; ++row) {
      const int count = host.first[row + 1] - host.first[row];
      const int before = lower[row + 1] - lower[row] + (diagonal[row] >= 0 ? 1 : 0);
      upper.push_back(upper.back() + count - before);
    }
  }

  // (num couplings): the place of each of the host's couplings.
  std::vector<int> order() const
  {
    std::vector<int> result;
    result.reserve(upper.back());
    const auto append = [&result](int begin, int end) {
      for (int k = begin; k < end; ++k) {
        result.push_back(k);
      }
    };
    for (std::size_t row = 0; row < diagonal.size(); ++row) {
      append(lower[row], lower[row + 1]);
      append(diagonal[row], diagonal[row] >= 0 ? diagonal[row] + 1 : diagonal[row]);
      append(upper[row], upper[row + 1]);
    }
    return result;
  }
};
} // namespace

std::vector<int> MatrixGraph::order(HostGraph const& host) { return Parts(host).order(); }

MatrixGraph::MatrixGraph(HostGraph const& host)
{
  const Parts parts(host);
  const auto places = parts.order();
  std::vector<int> in_order(host.columns.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    in_order[places[k]] = host.columns[k];
  }
  static_cast<DeviceGraph&>(*this) = DeviceGraph(host, in_order);
  lower = indices(parts.lower);
  upper = indices(parts.upper);
  diagonal = indices(parts.diagonal);
}

void DeviceGraph::share(NodeVector const& x) const
{
  if (ghosts) {
    ghosts->share(x);
  }
}

void DeviceGraph::gather(NodeVector const& x) const
{
  if (ghosts) {
    ghosts->gather(x);
  }
}
} // namespace asperity::multigrid
