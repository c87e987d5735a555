#pragma once

#include <array>
#include <cstdint>
#include <functional>

namespace asperity::mesh::detail
{
using Edge = std::array<int, 2>;

// Whether the first of two edges is the longer one: a strict order of all edges, also of those of
// equal length, so that neighbours agree on the longest edge of a shared facet.
using IsLonger = std::function<bool(Edge const&, Edge const&)>;

// A simplex with marks that determine the edge at whose midpoint it is bisected, and those of all
// its descendants. Facets are marked like cells of one dimension less: the facet of a marked cell
// is bisected in the same way as the marked simplex made of it. Orientation is preserved.
template <int Dim>
class MarkedSimplex;

template <>
class MarkedSimplex<1>
{
public:
  static constexpr std::array<Edge, 1> edges = {{{0, 1}}};

  MarkedSimplex(std::array<int, 2> const& vertices, IsLonger const&) : vertices_(vertices) {}

  std::array<int, 2> const& vertices() const { return vertices_; }
  Edge refinementEdge() const { return vertices_; }
  std::array<MarkedSimplex, 2> children(int midpoint) const
  {
    return {MarkedSimplex({vertices_[0], midpoint}), MarkedSimplex({midpoint, vertices_[1]})};
  }

private:
  explicit MarkedSimplex(std::array<int, 2> const& vertices) : vertices_(vertices) {}

  std::array<int, 2> vertices_;
};

// Newest vertex bisection: the refinement edge joins the first two vertices, the third is newest.
// Mitchell, ACM Trans. Math. Software 15 (1989), 326.
template <>
class MarkedSimplex<2>
{
public:
  static constexpr std::array<Edge, 3> edges = {{{0, 1}, {1, 2}, {2, 0}}};

  MarkedSimplex(std::array<int, 3> const& vertices, IsLonger const& is_longer) : vertices_(vertices)
  {
    auto const& [i, j, k] = vertices;
    for (auto const& turned : {std::array<int, 3>{j, k, i}, std::array<int, 3>{k, i, j}}) {
      if (is_longer({turned[0], turned[1]}, refinementEdge())) {
        vertices_ = turned;
      }
    }
  }

  std::array<int, 3> const& vertices() const { return vertices_; }
  Edge refinementEdge() const { return {vertices_[0], vertices_[1]}; }
  std::array<MarkedSimplex, 2> children(int midpoint) const
  {
    auto const& [i, j, k] = vertices_;
    return {MarkedSimplex({k, i, midpoint}), MarkedSimplex({j, k, midpoint})};
  }

private:
  explicit MarkedSimplex(std::array<int, 3> const& vertices) : vertices_(vertices) {}

  std::array<int, 3> vertices_;
};

// Arnold, Mukherjee & Pouly, SIAM J. Sci. Comput. 22 (2000), 431: every face has a marked edge, the
// refinement edge is that of the two faces that share it. Face f lies opposite vertex f.
template <>
class MarkedSimplex<3>
{
public:
  static constexpr std::array<Edge, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

  MarkedSimplex(std::array<int, 4> const& vertices, IsLonger const& is_longer);

  std::array<int, 4> const& vertices() const { return vertices_; }
  Edge refinementEdge() const { return {vertices_[ends_[0]], vertices_[ends_[1]]}; }
  std::array<MarkedSimplex, 2> children(int midpoint) const
  {
    return {child(ends_[0], ends_[1], midpoint), child(ends_[1], ends_[0], midpoint)};
  }

private:
  // Type P of the paper: the marked edges of all faces lie in one plane.
  bool isPlanar() const { return apex_[ends_[0]] == apex_[ends_[1]]; }

  // The child that keeps one end of the refinement edge and has the midpoint instead of the other.
  MarkedSimplex child(int kept, int replaced, int midpoint) const;

  std::array<int, 4> vertices_;
  std::array<std::int8_t, 2> ends_; // of the refinement edge, 0 .. 3
  std::array<std::int8_t, 4> apex_; // of each face: its vertex, 0 .. 3, opposite its marked edge
  bool is_flagged_ = false;         // type P_f, if planar
};
} // namespace asperity::mesh::detail
