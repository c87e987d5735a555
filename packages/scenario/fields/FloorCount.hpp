#pragma once

#include "base/Archive.hpp"
#include "dynamics/State.hpp"
#include "dynamics/fault/Fault.hpp"

#include <string>

namespace asperity::scenario
{
// Counts the sliding nodes whose normal stress is on its floor, at the end of the accepted steps of
// a run.
class FloorCount
{
public:
  // The fault must outlive this.
  explicit FloorCount(dynamics::Fault const& fault);

  // Whether the normal stress can reach its floor: it follows the body, or the floor is not zero.
  bool matters() const;
  // Counts the nodes on the floor at the end of a step. Collective.
  void add(dynamics::State const& now);
  // The share [-], by measure, of the sliding part of the fault that was on the floor at the end of
  // the last step.
  double share() const { return share_; }

  // A line for run.log; empty if the floor does not matter.
  std::string report() const;

  void save(Archive& archive) const;
  void restore(Archive const& archive);

private:
  dynamics::Fault const& fault_;
  double sliding_ = 0; // measure of the nodes that slide
  double share_ = 0, largest_share_ = 0;
  std::int64_t node_steps_ = 0;
};
} // namespace asperity::scenario
