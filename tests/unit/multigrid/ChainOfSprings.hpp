#pragma once

#include "multigrid/Cycle.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace asperity::multigrid::test
{
inline constexpr int num_nodes = 900, width = 3; // of an aggregate
inline constexpr int last = num_nodes - 1;       // which is held

// A chain of springs with weak supports, whose last node is held. With a diagonal below 2 it is
// indefinite. With a window the sum over that many successive nodes, with alternating
// signs, is resisted, too: a strong coupling that no coarse level sees.
inline Eigen::MatrixXd chain(double diagonal = 2.01, int window = 0)
{
  Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(num_nodes, num_nodes);
  for (int i = 0; i < num_nodes; ++i) {
    Z(i, i) = diagonal;
    if (i > 0 && i < last) {
      Z(i, i - 1) = Z(i - 1, i) = -1;
    }
  }
  for (int first = 0; first + window <= last; ++first) {
    for (int i = first; i < first + window; ++i) {
      for (int k = first; k < first + window; ++k) {
        Z(i, k) += (i + k) % 2 == 0 ? 1 : -1;
      }
    }
  }
  return Z;
}

// Constant on aggregates, zero at the held node.
inline Eigen::MatrixXd prolongator()
{
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(num_nodes, num_nodes / width);
  for (int i = 0; i < last; ++i) {
    P(i, i / width) = 1;
  }
  return P;
}

struct Matrix
{
  explicit Matrix(Eigen::MatrixXd const& A)
  {
    std::vector<float> entries;
    graph.row_size = graph.column_size = 1;
    graph.num_rows = static_cast<int>(A.rows());
    graph.num_owned = graph.num_columns = static_cast<int>(A.cols());
    graph.first = {0};
    for (int row = 0; row < A.rows(); ++row) {
      for (int column = 0; column < A.cols(); ++column) {
        if (A(row, column) != 0) {
          graph.columns.push_back(column);
          entries.push_back(static_cast<float>(A(row, column)));
        }
      }
      graph.first.push_back(static_cast<int>(graph.columns.size()));
    }
    blocks = makeNumbers<HostBlocks>(entries.size());
    std::copy(entries.begin(), entries.end(), blocks.data());
  }

  HostGraph graph;
  HostBlocks blocks;
};

inline NodeVector numbers(Eigen::VectorXd const& values)
{
  const auto result = makeNumbers<HostBlocks>(values.size());
  std::copy_n(values.data(), values.size(), result.data());
  return onDevice(result);
}

inline Eigen::VectorXd valuesOf(NodeVector const& x)
{
  const auto host = toHost(x);
  return Eigen::Map<const Eigen::VectorXf>(host.data(), num_nodes).cast<double>();
}

inline CoarsestRows allRows(int num_rows)
{
  CoarsestRows rows;
  rows.num_rows = num_rows;
  for (int row = 0; row < num_rows; ++row) {
    rows.places.push_back(row);
  }
  rows.sum = [](double*, int) {}; // there is one rank
  return rows;
}

// How blocks at all nodes act on the coarse level: Q is P.
inline HostAddedBlocks addedAtAllNodes(HostGraph const& level)
{
  const Matrix Q(prolongator());
  HostAddedBlocks added;
  added.graph = Q.graph;
  added.Q = Q.blocks;
  added.first = {0};
  for (int node = 0; node < num_nodes; ++node) {
    if (node < last) { // one column
      added.couplings.push_back(level.find(node / width, node / width));
    }
    added.first.push_back(static_cast<int>(added.couplings.size()));
  }
  for (int row = 0; row < level.num_rows; ++row) {
    added.rows.push_back(row);
  }
  return added;
}

// How sweeps take their rows.
struct Order
{
  RowOrder order = defaultRowOrder();
  int num_threads = 1;
};

// Where kernels run on the host, colours and any number of chunks can be swept.
inline std::vector<Order> orders()
{
  if (kernels_run_on_host) {
    return {{RowOrder::chunks, 1}, {RowOrder::chunks, 3}, {RowOrder::colours, 1}};
  }
  return {{RowOrder::colours, 1}};
}

// Those that contract.
inline std::vector<std::string> smoothers()
{
  auto names = SmootherRegistry::instance().names();
  names.erase(std::remove(names.begin(), names.end(), "Nothing"), names.end()); // of a test
  return names;
}

inline std::shared_ptr<const Hierarchy> twoLevels(double diagonal, Order order, int window = 0)
{
  const Eigen::MatrixXd Z = chain(diagonal, window), P = prolongator();
  const Matrix fine(Z), between(P), coarse(P.transpose() * Z * P);
  std::vector<HostLevel> levels(2);
  levels[0].graph = fine.graph;
  levels[0].prolongation = between.graph;
  levels[0].P = between.blocks;
  levels[1].graph = coarse.graph;
  levels[1].terms = {coarse.blocks};
  levels[1].added = addedAtAllNodes(coarse.graph);
  return std::make_shared<const Hierarchy>(levels, allRows(coarse.graph.num_rows), order.order,
                                           order.num_threads);
}

// The cycle for a chain with blocks H at all nodes, some of which are removed.
struct Chain
{
  explicit Chain(Order order = {}, double diagonal = 2.01, int window = 0,
                 std::string const& smoother = Cycle::usual_smoother)
      : H("H", num_nodes, 1, 1)
      , removed("removed", num_nodes)
      , hierarchy(twoLevels(diagonal, order, window))
  {
    const auto H_on_host = Kokkos::create_mirror_view(H);
    const auto removed_on_host = Kokkos::create_mirror_view(removed);
    std::vector<int> dofs;
    for (int node = 0; node < num_nodes; ++node) {
      dofs.push_back(node);
      H_on_host(node, 0, 0) = blockAt(node);
      removed_on_host(node) = isFree(node) || node == last ? 0 : 1;
    }
    Kokkos::deep_copy(H, H_on_host);
    Kokkos::deep_copy(removed, removed_on_host);
    std::vector<char> held(num_nodes, 0);
    held[last] = 1;
    const auto dofs_on_device = indices(dofs);
    cycle = std::make_unique<Cycle>(hierarchy, std::vector<double>{1},
                                    Matrix(chain(diagonal, window)).blocks, held,
                                    Cycle::Dofs(dofs_on_device.data(), num_nodes, 1), smoother);
  }

  static double blockAt(int node) { return node % 4; }
  static bool isFree(int node) { return node != last && node % 7 != 3; }

  // Z + H on the free nodes.
  static Eigen::MatrixXd matrix()
  {
    Eigen::MatrixXd A = chain();
    for (int i = 0; i < num_nodes; ++i) {
      A(i, i) += blockAt(i);
      for (int j = 0; j < num_nodes; ++j) {
        A(i, j) = isFree(i) && isFree(j) ? A(i, j) : 0;
      }
    }
    return A;
  }

  static Eigen::VectorXd force(int sequence)
  {
    Eigen::VectorXd r(num_nodes);
    for (int i = 0; i < num_nodes; ++i) {
      r(i) = isFree(i) ? std::sin(1. + sequence + i * i) : 0;
    }
    return r;
  }

  struct Result
  {
    Eigen::VectorXd z, image;
  };
  Result run(Eigen::VectorXd const& r) const
  {
    const auto given = makeNumbers(num_nodes);
    cycle->toRows(onNodes(r), 1, given);
    auto const result = cycle->run(given, true);
    return {fromRows(result.z), fromRows(result.image)};
  }
  Eigen::VectorXd fromRows(NodeVector const& x) const
  {
    const NodeView result("result", num_nodes);
    cycle->fromRows(x, 1, result);
    return ofNodes(result);
  }

  static NodeView onNodes(Eigen::VectorXd const& values)
  {
    const NodeView result("values", num_nodes);
    const auto host = Kokkos::create_mirror_view(result);
    std::copy_n(values.data(), num_nodes, host.data());
    Kokkos::deep_copy(result, host);
    return result;
  }
  static Eigen::VectorXd ofNodes(NodeView const& view)
  {
    const auto host = toHost(view);
    return Eigen::Map<const Eigen::VectorXd>(host.data(), num_nodes);
  }

  HessianView H;
  FlagView removed;
  std::shared_ptr<const Hierarchy> hierarchy;
  std::unique_ptr<Cycle> cycle;
};
} // namespace asperity::multigrid::test
