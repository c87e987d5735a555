#include "fem/FaultPoints.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>

namespace asperity::fem
{
FaultPoints::FaultPoints(std::vector<int> const& point_of_node, int num_points,
                         Communicator const& communicator)
    : of_node_(point_of_node)
    , num_points_(num_points)
{
  std::vector<int> counts(num_points, 0), first_nodes(num_points, 0);
  for (auto node = static_cast<int>(of_node_.size()) - 1; node >= 0; --node) {
    ++counts[of_node_[node]];
    first_nodes[of_node_[node]] = node;
  }
  ASPERITY_ASSERT(std::count(counts.begin(), counts.end(), 0) == 0);
  const auto joints = std::count_if(counts.begin(), counts.end(), [](int n) { return n > 1; });
  num_joints_ = sumOverRanks(static_cast<std::int64_t>(joints), communicator);
  points_of_nodes_ = toDevice(of_node_, "asperity::fem::pointsOfNodes");
  first_nodes_ = toDevice(first_nodes, "asperity::fem::firstNodesOfPoints");
}

std::vector<double> FaultPoints::sums(std::vector<double> const& values) const
{
  ASPERITY_ASSERT(values.size() == of_node_.size());
  std::vector<double> result(num_points_, 0.);
  for (std::size_t node = 0; node < values.size(); ++node) {
    result[of_node_[node]] += values[node];
  }
  return result;
}

std::vector<double> FaultPoints::means(std::vector<double> const& values,
                                       std::vector<double> const& weights) const
{
  ASPERITY_ASSERT(values.size() == of_node_.size() && weights.size() == of_node_.size());
  std::vector<double> result(num_points_, 0.);
  for (std::size_t node = 0; node < values.size(); ++node) {
    if (weights[node] > 0) {
      result[of_node_[node]] = values[node];
    }
  }
  auto excess = weights;
  for (std::size_t node = 0; node < values.size(); ++node) {
    excess[node] *= values[node] - result[of_node_[node]];
  }
  auto const all = sums(weights), more = sums(excess);
  for (std::size_t point = 0; point < result.size(); ++point) {
    ASPERITY_ASSERT(all[point] > 0);
    result[point] += more[point] / all[point];
  }
  return result;
}

void FaultPoints::gather(ConstNodeView const& at_nodes, NodeView const& at_points) const
{
  auto const first_nodes = first_nodes_;
  Kokkos::parallel_for(
    "asperity::fem::gatherAtPoints", RangePolicy(0, first_nodes.extent(0)),
    KOKKOS_LAMBDA(int point) { at_points(point) = at_nodes(first_nodes(point)); });
}

void FaultPoints::scatter(ConstNodeView const& at_points, NodeView const& at_nodes) const
{
  auto const points = points_of_nodes_;
  Kokkos::parallel_for(
    "asperity::fem::scatterFromPoints", RangePolicy(0, points.extent(0)),
    KOKKOS_LAMBDA(int node) { at_nodes(node) = at_points(points(node)); });
}
} // namespace asperity::fem
