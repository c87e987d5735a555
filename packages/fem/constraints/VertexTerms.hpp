#pragma once

#include "mesh/Mesh.hpp"

#include <array>
#include <vector>

namespace asperity::fem
{
// How the unknowns at the nodes make the vectors at the vertices, where a fault inside the body has
// split vertices in two. Of such a pair the node of `minus` carries the mean m, that of `plus` the
// jump d over the fault:
//
//   v+ = m + d/2,  v- = m - d/2
//
// At a tip the jump is held at zero, and no cell has the vertex `plus`. Every other vertex is a
// node of its own.
class VertexTerms
{
public:
  struct Term
  {
    int node;
    double factor;
  };

  // The terms of one vertex, to loop over.
  class Terms
  {
  public:
    explicit Terms(Term only) : terms_{{only, {}}}, size_(1) {}
    Terms(Term mean, Term jump) : terms_{{mean, jump}}, size_(2) {}
    Term const* begin() const { return terms_.data(); }
    Term const* end() const { return terms_.data() + size_; }

  private:
    std::array<Term, 2> terms_;
    int size_;
  };

  VertexTerms(int num_vertices, std::vector<SplitVertex> const& splits);

  Terms at(int vertex) const
  {
    const int split = split_of_[vertex];
    if (split < 0) {
      return Terms({represented_[vertex], 1});
    }
    return {{splits_[split].minus, 1},
            {splits_[split].plus, represented_[vertex] == splits_[split].plus ? 0.5 : -0.5}};
  }

  // Whether the vertex is a node of its own.
  bool isNode(int vertex) const { return split_of_[vertex] < 0 && represented_[vertex] == vertex; }

  // Whether the node carries the jump over a fault, which rigid motions of the body do not have.
  bool isJump(int node) const { return is_jump_[node]; }

  // From vectors(num vertices, components) at the owned vertices to unknowns at the owned nodes:
  // replaces those of v+ and v- by d and m. At a tip they are 0 and v-.
  void toMeanAndJump(std::vector<double>& vectors, int components) const;

private:
  std::vector<SplitVertex> all_splits_;
  std::vector<SplitVertex> splits_; // without tips
  std::vector<int> split_of_;       // (num_vertices), -1 where a vertex is a node of its own
  std::vector<int> represented_;    // (num_vertices)
  std::vector<bool> is_jump_;       // (num_vertices)
};
} // namespace asperity::fem
