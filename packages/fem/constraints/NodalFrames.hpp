#pragma once

#include "fem/constraints/VertexTerms.hpp"
#include "fem/dofs/DofMap.hpp"

#include <array>
#include <vector>

namespace asperity::fem
{
// An orthonormal frame at each local node. Components of vectors are taken along its rows, so that
// a condition on a direction (the normal of a dipping fault, say) becomes a condition on one
// component. components <= 3; row r, column c of the frame of a node is entry(node, r, c). A frame
// is the identity until it is set.
//
// The vector at a vertex follows from the unknowns x as the sum over the terms of the vertex of
// factor * frame(node)^T x(node).
class NodalFrames
{
public:
  using Matrix =
    std::array<double, 9>; // row-major, the leading components x components block is used

  // splits: those of the mesh.
  NodalFrames(int num_nodes, int components, std::vector<SplitVertex> const& splits = {})
      : components_(components)
      , frames_(num_nodes, identity(components))
      , is_turned_(num_nodes, false)
      , terms_(num_nodes, splits)
  {
  }

  VertexTerms::Terms terms(int vertex) const { return terms_.at(vertex); }
  VertexTerms const& vertexTerms() const { return terms_; }
  void setShares(std::vector<double> const& of_joints) { terms_.setShares(of_joints); }

  static Matrix identity(int components)
  {
    Matrix matrix{};
    for (int c = 0; c < components; ++c) {
      matrix[c * components + c] = 1;
    }
    return matrix;
  }

  int components() const { return components_; }
  int numNodes() const { return static_cast<int>(frames_.size()); }
  Matrix const& frame(int node) const { return frames_[node]; }
  void set(int node, Matrix const& frame)
  {
    frames_[node] = frame;
    is_turned_[node] = frame != identity(components_);
  }
  // Whether the unknowns at the vertex's node are the components of its vector along the axes, as
  // they are at most vertices.
  bool isPlain(int vertex) const { return !is_turned_[vertex] && terms_.isNode(vertex); }
  double entry(int node, int row, int column) const
  {
    return frames_[node][row * components_ + column];
  }
  // The direction along the axes in which a component is measured; z in antiplane motion.
  std::array<double, 3> row(int node, int component) const
  {
    std::array<double, 3> direction{};
    for (int c = 0; c < components_; ++c) {
      direction[components_ == 1 ? 2 : c] = entry(node, component, c);
    }
    return direction;
  }

  // local = frame * global; both of length components.
  void toFrame(int node, double const* global, double* local) const
  {
    for (int r = 0; r < components_; ++r) {
      local[r] = 0;
      for (int c = 0; c < components_; ++c) {
        local[r] += entry(node, r, c) * global[c];
      }
    }
  }

  void fromFrame(int node, double const* local, double* global) const
  {
    for (int c = 0; c < components_; ++c) {
      global[c] = 0;
      for (int r = 0; r < components_; ++r) {
        global[c] += entry(node, r, c) * local[r];
      }
    }
  }

private:
  int components_;
  std::vector<Matrix> frames_;
  std::vector<bool> is_turned_;
  VertexTerms terms_;
};

// Components along the axes of a vector of owned dofs: at all owned vertices (num owned nodes,
// components), or at some of them (vertices, components).
std::vector<double> alongAxes(NodalFrames const& frames, DofMap const& dofs, Vector const& x);
std::vector<double> alongAxes(NodalFrames const& frames, DofMap const& dofs, Vector const& x,
                              std::vector<int> const& vertices);

// The reverse: the unknowns (num owned nodes, components) that give vectors along the axes at the
// owned vertices (num owned nodes, components).
std::vector<double> unknownsOf(NodalFrames const& frames, std::vector<double> along_axes);

// The components of a node's frame along a boundary, ascending: all but the one that is nearest to
// the boundary's normal. The frame may deviate from that normal where the boundary bends or ends at
// a wall. In antiplane motion the single component is along any boundary.
template <std::size_t Dim>
std::vector<int> tangentialComponents(NodalFrames const& frames, int node,
                                      std::array<double, Dim> const& normal);
} // namespace asperity::fem
