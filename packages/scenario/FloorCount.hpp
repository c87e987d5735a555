#pragma once

#include "dynamics/Fault.hpp"
#include "dynamics/State.hpp"
#include "io/checkpoint/Archive.hpp"

#include <string>

namespace asperity::scenario
{
// How often the floor of the normal stress acts, at the accepted steps of a run: nodes that slide
// and whose normal stress is not above it.
class FloorCount
{
public:
  // The fault must outlive this.
  explicit FloorCount(dynamics::Fault const& fault);

  // Whether the normal stress may come to its floor: it follows the body, or the floor is not zero.
  bool matters() const;
  // The end of a step. Collective.
  void add(dynamics::State const& state);
  // The part of the fault that is on the floor since the last step [-], by measure, where friction
  // decides on the motion.
  double share() const { return share_; }

  // For run.log, a line; empty if it does not matter.
  std::string report() const;

  void save(io::Archive& archive, std::string const& path) const;
  void restore(io::Archive const& archive, std::string const& path);

private:
  dynamics::Fault const& fault_;
  double sliding_ = 0; // measure of the nodes that slide
  double share_ = 0, largest_share_ = 0;
  std::int64_t node_steps_ = 0;
};
} // namespace asperity::scenario
