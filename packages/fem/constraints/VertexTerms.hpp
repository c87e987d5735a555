#pragma once

#include "mesh/Crossings.hpp"
#include "mesh/Joints.hpp"

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
// Where two faults cross, the node of `mean` carries the mean of the four vertices, those of plus
// the jumps d1 over the first fault and d2 over the second one, which go on through the crossing:
//
//   v = m + s1 d1/2 + s2 d2/2
//
// where s1 is 1 on the plus side of the first fault and -1 on its minus side, s2 likewise for the
// second one. The fourth combination of four vertices adds s1 s2 e/4: the slip of each fault
// differs by e on the two sides of the other one. In the plane it would open a fault.
// In space, along the line of the crossing, it would not; there the restriction to e = 0 converges
// with the cell size. It is held at zero at the node of `both`.
//
// At a joint (mesh::Joint) the three vertices are those of the main fault's mean m and jump d, on
// the side of a branch with the jump b over that:
//
//   v = m +- d/2                              on the other side, and, on the branch's side,
//   v = m +- d/2 + (1 - s) b,  m +- d/2 - s b on the plus and the minus side of the branch
//
// s is the share of the main fault's facets at the vertex, by their measure, that lie on the plus
// side of the branch. So d is the mean of the main fault's slip on both sides of the branch,
// weighted like friction there, and the force that belongs to b is that across the facets of the
// branch alone: the parts of the main fault's tractions, s times (1 - s) on both sides, cancel. b
// lies in both faults; there may be a joint on each side of the main fault.
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
    explicit Terms(Term only) : terms_{{only, {}, {}}}, size_(1) {}
    Terms(Term mean, Term jump) : terms_{{mean, jump, {}}}, size_(2) {}
    Terms(Term mean, Term first_jump, Term second_jump)
        : terms_{{mean, first_jump, second_jump}}
        , size_(3)
    {
    }
    Term const* begin() const { return terms_.data(); }
    Term const* end() const { return terms_.data() + size_; }

  private:
    std::array<Term, 3> terms_;
    int size_;
  };

  VertexTerms(int num_vertices, std::vector<SplitVertex> const& splits);

  Terms at(int vertex) const
  {
    const int split = split_of_[vertex];
    if (split < 0) {
      return Terms({represented_[vertex], 1});
    }
    if (split < static_cast<int>(splits_.size())) {
      const Term mean = {splits_[split].minus, 1};
      const Term jump = {splits_[split].plus,
                         represented_[vertex] == splits_[split].plus ? 0.5 : -0.5};
      if (joint_of_[vertex] < 0) {
        return {mean, jump};
      }
      const int plus = joints_[joint_of_[vertex]].plus;
      const double share = shares_[joint_of_[vertex]];
      return {mean, jump, {plus, vertex == plus ? 1 - share : -share}};
    }
    auto const& [mean, plus, both] = crossings_[split - splits_.size()];
    const auto factor = [&, both = both](int jump) {
      return vertex == jump || vertex == both ? 0.5 : -0.5;
    };
    return {{mean, 1}, {plus[0], factor(plus[0])}, {plus[1], factor(plus[1])}};
  }

  // Whether the vertex is a node of its own.
  bool isNode(int vertex) const { return split_of_[vertex] < 0 && represented_[vertex] == vertex; }

  // The joints of the splits, and the share s of each, 1/2 until it is set.
  std::vector<mesh::Joint> const& joints() const { return joints_; }
  double share(std::size_t joint) const { return shares_[joint]; }
  void setShares(std::vector<double> const& shares); // (num_joints), in (0, 1)

  // Whether the node carries the jump over a fault, or what is held at a crossing, which rigid
  // motions of the body do not have.
  bool isJump(int node) const { return is_jump_[node]; }

  // The nodes at which all is held: tips, and what is no slip at crossings.
  std::vector<int> const& heldNodes() const { return held_nodes_; }

  // From vectors(num vertices, components) at the owned vertices to unknowns at the owned nodes:
  // replaces those of v+ and v- by d and m, the four at a crossing by m, d1, d2 and zero, and the
  // three at a joint by m, d and b. At a tip they are 0 and v-.
  void toMeanAndJump(std::vector<double>& vectors, int components) const;

private:
  std::vector<SplitVertex> tips_, splits_; // at tips; the others, but for crossings and joints
  std::vector<mesh::Crossing> crossings_;
  std::vector<mesh::Joint> joints_;
  std::vector<double> shares_; // (num_joints)
  std::vector<int> joint_of_;  // (num_vertices) of the vertices on both sides of a branch, or -1
  std::vector<int> split_of_;  // (num_vertices) in splits_, then crossings_; -1: a node of its own
  std::vector<int> represented_; // (num_vertices)
  std::vector<bool> is_jump_;    // (num_vertices)
  std::vector<int> held_nodes_;
};
} // namespace asperity::fem
