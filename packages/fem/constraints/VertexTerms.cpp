#include "fem/constraints/VertexTerms.hpp"

#include <numeric>

namespace asperity::fem
{
VertexTerms::VertexTerms(int num_vertices, std::vector<SplitVertex> const& splits)
    : all_splits_(splits)
    , split_of_(num_vertices, -1)
    , represented_(num_vertices)
    , is_jump_(num_vertices, false)
{
  std::iota(represented_.begin(), represented_.end(), 0);
  for (auto const& split : splits) {
    is_jump_[split.plus] = true;
    if (!split.is_tip) {
      split_of_[split.plus] = split_of_[split.minus] = static_cast<int>(splits_.size());
      splits_.push_back(split);
    }
  }
  for (auto const& split : splits) {
    if (split.is_tip) {
      represented_[split.plus] = split.minus;
      split_of_[split.plus] = split_of_[split.minus];
    }
  }
}

void VertexTerms::toMeanAndJump(std::vector<double>& vectors, int components) const
{
  const int num_owned = static_cast<int>(vectors.size()) / components;
  for (auto const& [plus, minus, is_tip] : all_splits_) {
    for (int c = 0; c < components && plus < num_owned; ++c) {
      double &above = vectors[plus * components + c], &below = vectors[minus * components + c];
      const double jump = is_tip ? 0 : above - below;
      below = is_tip ? below : 0.5 * (above + below);
      above = jump;
    }
  }
}
} // namespace asperity::fem
