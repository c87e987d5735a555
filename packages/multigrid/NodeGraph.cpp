#include "multigrid/NodeGraph.hpp"

#include <algorithm>

namespace asperity::multigrid
{
int HostGraph::find(int row, int column) const
{
  auto const begin = columns.begin() + first[row], end = columns.begin() + first[row + 1];
  auto const place = std::lower_bound(begin, end, column);
  return place != end && *place == column ? static_cast<int>(place - columns.begin()) : -1;
}

DeviceGraph::DeviceGraph(HostGraph const& host, std::vector<int> const& columns_in_order)
    : GraphSizes(host)
    , columns(indices(columns_in_order))
    , ghosts(host.ghosts)
{
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
  if (ghosts.share) {
    ghosts.share(x);
  }
}

void DeviceGraph::gather(NodeVector const& x) const
{
  if (ghosts.gather) {
    ghosts.gather(x);
  }
}
} // namespace asperity::multigrid
