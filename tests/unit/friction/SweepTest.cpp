#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

#include <random>

namespace asperity::friction::test
{
namespace
{
// A full symmetric system for a fault, on the host.
struct System
{
  std::vector<Values> Z, b;
  std::vector<int> held;
  Values curvature;

  System(int num_nodes, int T)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const int size = num_nodes * T;
    Z.assign(size, Values(size));
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column <= row; ++column) {
        Z[row][column] = Z[column][row] = (row == column ? 1e6 : 1e4 * number(random));
      }
      held.push_back(T == 2 && row % 7 == 0 ? 1 : 0);
    }
    for (int node = 0; node < num_nodes; ++node) {
      b.push_back(T == 1 ? Values{1e7 * number(random)}
                         : Values{1e7 * number(random), 1e7 * number(random)});
      curvature.push_back(2e6);
    }
  }

  // b - Z v
  std::vector<Values> residual(std::vector<Values> const& v) const
  {
    auto result = b;
    const std::size_t T = v[0].size();
    for (std::size_t row = 0; row < Z.size(); ++row) {
      Real sum = b[row / T][row % T];
      for (std::size_t column = 0; column < Z.size(); ++column) {
        sum -= Real(Z[row][column]) * v[column / T][column % T];
      }
      result[row / T][row % T] = static_cast<double>(sum);
    }
    return result;
  }

  // b - Z v + curvature v at a node; zero in held components.
  Values force(int node, std::vector<Values> const& v) const
  {
    auto result = residual(v)[node];
    for (std::size_t j = 0; j < result.size(); ++j) {
      result[j] = held[node * result.size() + j] ? 0 : result[j] + curvature[node] * v[node][j];
    }
    return result;
  }
};

std::vector<Values> onHost(BlockView const& v)
{
  const auto host = toHost(v);
  std::vector<Values> result(host.extent(0), Values(host.extent(1)));
  for (std::size_t i = 0; i < host.extent(0); ++i) {
    for (std::size_t j = 0; j < host.extent(1); ++j) {
      result[i][j] = host(i, j);
    }
  }
  return result;
}

IndexView flags(std::vector<int> const& values)
{
  const Kokkos::View<int*, MemorySpace> view("flags", values.size());
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i) = values[i];
  }
  Kokkos::deep_copy(view, host);
  return view;
}

// 1, 11 and 24 nodes: rows of any length, whatever the kernel takes at a time.
TEST(Sweep, MinimisesNodeByNode)
{
  for (std::string const& law : both_laws) {
    for (const int T : {1, 2}) {
      for (const int num_nodes : {1, 11, 24}) {
        auto nodes = variousNodes(law);
        nodes.resize(num_nodes, nodes[0]);
        const Fault fault(nodes);
        const System system(num_nodes, T);
        const auto curvature = toDevice(system.curvature);
        const auto start = std::vector<Values>(num_nodes, Values(T, 0.1));

        auto expected = start;
        for (int node = 0; node < num_nodes; ++node) {
          std::vector<Values> forces(num_nodes, Values(T, 0));
          forces[node] = system.force(node, expected);
          const auto v = toDevice(expected);
          ASSERT_EQ(
            fault.kernels->minimise(flags({node}), curvature, toDevice(forces), fault.at, v), 0);
          expected = onHost(v);
        }

        const auto v = toDevice(start);
        const DenseSystem coupled{toDevice(system.Z), toDevice(system.residual(start)),
                                  flags(system.held), curvature};
        EXPECT_EQ(fault.kernels->sweep(allNodes(num_nodes), coupled, fault.at, v), 0);
        const auto found = onHost(v);
        const auto left = onHost(coupled.r);
        const auto expected_left = system.residual(found);
        for (int node = 0; node < num_nodes; ++node) {
          for (int j = 0; j < T; ++j) {
            EXPECT_NEAR(found[node][j], expected[node][j], 1e-10 * std::abs(expected[node][j]))
              << law << ", node " << node << " of " << num_nodes << ", component " << j;
            EXPECT_NEAR(left[node][j], expected_left[node][j], 1e-13 * 1e7 * num_nodes)
              << law << ", node " << node << " of " << num_nodes << ", component " << j;
          }
        }
      }
    }
  }
}

TEST(Sweep, VisitsTheNodesGivenAndCountsFailures)
{
  const Fault fault(variousNodes("Regularised"));
  const int num_nodes = static_cast<int>(fault.alpha.extent(0));
  System system(num_nodes, 1);
  system.curvature[5] = 0; // without a minimiser
  const std::vector<Values> start(num_nodes, Values{0.5});
  const auto v = toDevice(start);
  const DenseSystem coupled{toDevice(system.Z), toDevice(system.residual(start)),
                            flags(system.held), toDevice(system.curvature)};
  EXPECT_EQ(fault.kernels->sweep(flags({2, 5, 9}), coupled, fault.at, v), 1);
  const auto found = onHost(v);
  for (int node = 0; node < num_nodes; ++node) {
    EXPECT_EQ(found[node][0] != 0.5, node == 2 || node == 9) << node;
  }
}
} // namespace
} // namespace asperity::friction::test
