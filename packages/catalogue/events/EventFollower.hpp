#pragma once

#include "catalogue/events/FaultRates.hpp"
#include "io/Output.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// An output that follows the events on the fault: an event is a contiguous time in which some node
// slides at least as fast as the threshold; nothing is merged. Times between two accepted steps are
// linear in the logarithm of the slip rate. Nodes whose slip rate is prescribed do not count.
class EventFollower : public io::Output
{
public:
  void write(io::StepInfo const& step) override;
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

  bool eventInProgress() const { return in_progress_; }

protected:
  // boundary: of several that the fault is made of, the one whose nodes alone count.
  EventFollower(io::OutputContext const& context, double threshold,
                std::optional<int> boundary = {});

  struct Sample
  {
    double time = 0;           // [s]
    double peak = 0;           // [m/s] of all ranks
    std::vector<double> rates; // (num_owned) [m/s], 0 of nodes that do not count
  };

  // The sample `now` is, for begin, the first one of an event; for follow, each one of the event
  // and the first one after it; for end, the first one after it. Called in this order. Collective.
  virtual void begin(Sample const& now) = 0;
  virtual void follow(Sample const& now) = 0;
  virtual void end(Sample const& now) = 0;

  // When the fault as a whole, or the owned node `i`, met the threshold between the previous sample
  // and `now`; at `now`, if that is the first one. [s]
  double crossingTime(Sample const& now) const;
  double crossingTime(Sample const& now, std::size_t i) const;

  io::OutputDomain const& fault() const { return fault_; }
  double threshold() const { return threshold_; }
  bool hasPrevious() const { return has_previous_; }
  Sample const& previous() const { return previous_; }

  // An event that is in progress at the end of the run is over then, though not complete.
  void stop() { in_progress_ = false; }

private:
  io::OutputDomain const& fault_;
  io::OutputField const& slip_rate_;
  std::vector<double> counts_; // (num_owned) countedNodes, of the boundary alone
  double threshold_;           // [m/s]
  bool is_of_boundary_;
  bool in_progress_ = false;
  bool has_previous_ = false;
  Sample previous_;
};

// The place of the node that meets the threshold first, among those of all ranks.
struct FirstNode
{
  std::vector<double> coordinates;                            // (dimension) [m]
  double position = std::numeric_limits<double>::quiet_NaN(); // [m] on a curve
};

// lateness: (num_owned) any number that orders the nodes in time; infinity means never. Among
// equals the node of least number is the first. Some value must be finite. Collective.
FirstNode firstNode(io::OutputDomain const& fault, std::vector<double> const& lateness);
} // namespace asperity::catalogue
