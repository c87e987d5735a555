#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
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
      b.emplace_back();
      for (int j = 0; j < T; ++j) {
        b.back().push_back(1e7 * number(random));
      }
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

// With bounds a block has one more component, which friction does not see.
TEST(Sweep, MovesTheLastComponentIntoItsBounds)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const int T : {1, 2}) {
    const auto reference = variousNodes("Regularised");
    const int num_nodes = static_cast<int>(reference.size()), size = T + 1;
    const Fault fault(reference);
    System system(num_nodes, size);
    Values lower(num_nodes, -infinity), upper(num_nodes, infinity);
    for (int node = 0; node < num_nodes; ++node) {
      (node % 2 == 0 ? lower : upper)[node] = 0.1 * (node % 5 - 2);
    }
    system.held.assign(num_nodes * size, 0);
    system.held[3 * size + T] = 1;
    lower[3] = -infinity;
    upper[3] = infinity;
    const auto curvature = toDevice(system.curvature);
    const auto start = std::vector<Values>(num_nodes, Values(size, 0));

    auto expected = start;
    int num_at_bounds = 0;
    for (int node = 0; node < num_nodes; ++node) {
      auto const force = system.force(node, expected);
      std::vector<Values> along(num_nodes, Values(T, 0)), forces = along;
      std::copy_n(force.begin(), T, forces[node].begin());
      std::copy_n(expected[node].begin(), T, along[node].begin());
      const auto v = toDevice(along);
      ASSERT_EQ(fault.kernels->minimise(flags({node}), curvature, toDevice(forces), fault.at, v),
                0);
      auto const found = onHost(v)[node];
      std::copy_n(found.begin(), T, expected[node].begin());
      const double free = force[T] / system.curvature[node];
      expected[node][T] = std::min(std::max(free, lower[node]), upper[node]);
      num_at_bounds += expected[node][T] != free ? 1 : 0;
    }
    EXPECT_GT(num_at_bounds, 3);
    EXPECT_LT(num_at_bounds, num_nodes - 3);

    const auto v = toDevice(start);
    const DenseSystem coupled{toDevice(system.Z),
                              toDevice(system.residual(start)),
                              flags(system.held),
                              curvature,
                              {true, toDevice(lower), toDevice(upper)}};
    EXPECT_EQ(fault.kernels->sweep(allNodes(num_nodes), coupled, fault.at, v), 0);
    const auto found = onHost(v);
    const auto left = onHost(coupled.r);
    const auto expected_left = system.residual(found);
    for (int node = 0; node < num_nodes; ++node) {
      for (int j = 0; j < size; ++j) {
        EXPECT_NEAR(found[node][j], expected[node][j], 1e-10 * std::abs(expected[node][j]) + 1e-300)
          << "node " << node << ", component " << j;
        EXPECT_NEAR(left[node][j], expected_left[node][j], 1e-13 * 1e7 * num_nodes)
          << "node " << node << ", component " << j;
      }
    }
    EXPECT_EQ(found[3][T], 0) << "held";
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
