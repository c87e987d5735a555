#include "fem/constraints/VertexTerms.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <numeric>

namespace asperity::fem
{
VertexTerms::VertexTerms(int num_vertices, std::vector<SplitVertex> const& splits)
    : crossings_(mesh::crossingsOf(splits))
    , joints_(mesh::jointsOf(splits))
    , shares_(joints_.size(), 0.5)
    , joint_of_(num_vertices, -1)
    , split_of_(num_vertices, -1)
    , represented_(num_vertices)
    , is_jump_(num_vertices, false)
{
  std::iota(represented_.begin(), represented_.end(), 0);
  std::vector<bool> is_mean_of_crossing(num_vertices, false);
  for (auto const& crossing : crossings_) {
    is_mean_of_crossing[crossing.mean] = true;
    held_nodes_.push_back(crossing.both);
  }
  for (auto const& split : splits) {
    is_jump_[split.plus] = true;
    if (split.is_tip) {
      tips_.push_back(split);
      held_nodes_.push_back(split.plus);
    } else if (!split.is_joint && !is_mean_of_crossing[split.minus]) {
      split_of_[split.plus] = split_of_[split.minus] = static_cast<int>(splits_.size());
      splits_.push_back(split);
    }
  }
  auto number = static_cast<int>(splits_.size());
  for (auto const& [mean, plus, both] : crossings_) {
    split_of_[mean] = split_of_[plus[0]] = split_of_[plus[1]] = split_of_[both] = number++;
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    auto const& joint = joints_[i];
    joint_of_[joint.plus] = joint_of_[joint.minus] = static_cast<int>(i);
    represented_[joint.plus] = joint.minus;
    split_of_[joint.plus] = split_of_[joint.minus];
  }
  for (auto const& tip : tips_) {
    represented_[tip.plus] = tip.minus;
    split_of_[tip.plus] = split_of_[tip.minus];
  }
}

void VertexTerms::setShares(std::vector<double> const& shares)
{
  ASPERITY_ASSERT(shares.size() == joints_.size());
  shares_ = shares;
}

void VertexTerms::toMeanAndJump(std::vector<double>& vectors, int components) const
{
  const int num_owned = static_cast<int>(vectors.size()) / components;
  const auto at = [&](int vertex, int c) -> double& { return vectors[vertex * components + c]; };
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    for (int c = 0; c < components && joints_[i].plus < num_owned; ++c) {
      double &above = at(joints_[i].plus, c), &below = at(joints_[i].minus, c);
      const double jump = above - below;
      below = shares_[i] * above + (1 - shares_[i]) * below;
      above = jump;
    }
  }
  for (auto const& [plus, minus, is_tip, is_joint] : splits_) {
    for (int c = 0; c < components && plus < num_owned; ++c) {
      double &above = at(plus, c), &below = at(minus, c);
      const double jump = above - below;
      below = 0.5 * (above + below);
      above = jump;
    }
  }
  for (auto const& [mean, plus, both] : crossings_) {
    for (int c = 0; c < components && mean < num_owned; ++c) {
      const double of_none = at(mean, c), of_first = at(plus[0], c), of_second = at(plus[1], c),
                   of_both = at(both, c);
      at(mean, c) = 0.25 * (of_none + of_first + of_second + of_both);
      at(plus[0], c) = 0.5 * (of_first + of_both - of_none - of_second);
      at(plus[1], c) = 0.5 * (of_second + of_both - of_none - of_first);
      at(both, c) = 0;
    }
  }
  for (auto const& tip : tips_) {
    for (int c = 0; c < components && tip.plus < num_owned; ++c) {
      at(tip.plus, c) = 0;
    }
  }
}
} // namespace asperity::fem
