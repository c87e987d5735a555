#pragma once

#include "friction/Parameter.hpp"
#include "friction/Types.hpp"

#include <map>
#include <numeric>
#include <string>
#include <vector>

// Between vectors on the host and views on the device.
namespace asperity::friction::test
{
using Values = std::vector<double>;

inline NodeView toDevice(Values const& values) { return asperity::toDevice(values, "values"); }

// One row of T values for each node.
inline BlockView toDevice(std::vector<Values> const& rows)
{
  const BlockView view("rows", rows.size(), rows.at(0).size());
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      host(i, j) = rows[i][j];
    }
  }
  Kokkos::deep_copy(view, host);
  return view;
}

// parameters(num_parameters, num_nodes) from one row of parameters for each node.
inline ParameterView parametersOf(std::vector<Values> const& nodes)
{
  const Kokkos::View<double**, MemorySpace> view("parameters", nodes.at(0).size(), nodes.size());
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t k = 0; k < nodes[i].size(); ++k) {
      host(k, i) = nodes[i][k];
    }
  }
  Kokkos::deep_copy(view, host);
  return view;
}

// The law with these parameters by name, and the defaults for the others.
template <class Law>
Law lawWith(std::map<std::string, double> const& given)
{
  Values values;
  for (auto const& row : Law::parameters) {
    auto const found = given.find(row.parameter.name);
    values.push_back(found == given.end() ? row.parameter.default_value : found->second);
  }
  return loadLaw<Law>(values.data());
}

inline IndexView allNodes(int num_nodes)
{
  std::vector<int> nodes(num_nodes);
  std::iota(nodes.begin(), nodes.end(), 0);
  return asperity::toDevice(nodes, "nodes");
}
} // namespace asperity::friction::test
