#pragma once

#include "base/Warning.hpp"
#include "dynamics/checks/FrontZone.hpp"
#include "dynamics/observables/FaultSample.hpp"
#include "io/Archive.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace asperity::scenario
{
// Notes the fewest cells that the zone behind a front of slip has in a run, by the state, slip rate
// and effective normal stress of each step.
class FrontWatch
{
public:
  // Neither has to be there; the fault must outlive this.
  FrontWatch(std::optional<dynamics::FrontZone> zone, dynamics::Fault const& fault);

  // Looks at the end of a step, at `time` [s]; a warning the first time that the zone has fewer
  // cells than scenario::fewest_cells_of_front, and again when it has half of what was told. The
  // same on all ranks. Collective.
  std::optional<Warning> note(dynamics::State const& now, dynamics::FaultSample const& sample,
                              double time);

  // A line for run.log; empty if friction fell nowhere.
  std::string report() const;

  void save(io::Archive& archive, std::string const& path) const;
  void restore(io::Archive const& archive, std::string const& path);

private:
  std::optional<dynamics::FrontZone> zone_;
  dynamics::Fault const& fault_;
  double cells_ = std::numeric_limits<double>::infinity(); // fewest so far
  double length_ = 0, time_ = 0;                           // of that zone [m], [s]
  std::array<double, 3> place_{};                          // [m]
  double told_ = std::numeric_limits<double>::infinity();
};
} // namespace asperity::scenario
