#include "fem/constraints/NodalFrames.hpp"

#include "base/Errors.hpp"

#include <Tpetra_Vector.hpp>

#include <array>
#include <cmath>
#include <numeric>

namespace asperity::fem
{
std::vector<double> alongAxes(NodalFrames const& frames, DofMap const& dofs, Vector const& x)
{
  std::vector<int> all(dofs.numOwnedNodes());
  std::iota(all.begin(), all.end(), 0);
  return alongAxes(frames, dofs, x, all);
}

std::vector<double> alongAxes(NodalFrames const& frames, DofMap const& dofs, Vector const& x,
                              std::vector<int> const& vertices)
{
  const int components = dofs.components();
  auto const values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> result(vertices.size() * components, 0.);
  double* at_vertex = result.data();
  for (int vertex : vertices) {
    if (frames.isPlain(vertex)) {
      for (int c = 0; c < components; ++c) {
        at_vertex[c] = values(dofs.dof(vertex, c), 0);
      }
    } else {
      for (auto const& [node, factor] : frames.terms(vertex)) {
        std::array<double, 3> local{};
        std::array<double, 3> global{};
        for (int c = 0; c < components; ++c) {
          local[c] = values(dofs.dof(node, c), 0);
        }
        frames.fromFrame(node, local.data(), global.data());
        for (int c = 0; c < components; ++c) {
          at_vertex[c] += factor * global[c];
        }
      }
    }
    at_vertex += components;
  }
  return result;
}

std::vector<double> unknownsOf(NodalFrames const& frames, std::vector<double> along_axes)
{
  const int components = frames.components();
  frames.vertexTerms().toMeanAndJump(along_axes, components);
  std::vector<double> result(along_axes.size());
  for (int node = 0; node < static_cast<int>(result.size()) / components; ++node) {
    frames.toFrame(node, &along_axes[node * components], &result[node * components]);
  }
  return result;
}

template <std::size_t Dim>
std::vector<int> tangentialComponents(NodalFrames const& frames, int node,
                                      std::array<double, Dim> const& normal)
{
  const int components = frames.components();
  if (components == 1) {
    return {0};
  }
  ASPERITY_ASSERT(components == static_cast<int>(Dim));
  int across = 0;
  double largest = -1;
  for (int row = 0; row < components; ++row) {
    double share = 0;
    for (int c = 0; c < components; ++c) {
      share += frames.entry(node, row, c) * normal[c];
    }
    if (std::abs(share) > largest) {
      largest = std::abs(share);
      across = row;
    }
  }
  std::vector<int> tangents;
  for (int row = 0; row < components; ++row) {
    if (row != across) {
      tangents.push_back(row);
    }
  }
  return tangents;
}

template std::vector<int> tangentialComponents(NodalFrames const&, int,
                                               std::array<double, 2> const&);
template std::vector<int> tangentialComponents(NodalFrames const&, int,
                                               std::array<double, 3> const&);
} // namespace asperity::fem
