#pragma once

#include "dynamics/watches/Watch.hpp"
#include "parameters/Parameters.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace asperity::scenario
{
// Notes the fewest cells that the zone behind a front of slip has in a run, by the state, slip rate
// and effective normal stress of each step.
class FrontWatch : public dynamics::Watch
{
public:
  // There may be no zone.
  FrontWatch(ParameterList const&, dynamics::WatchContext const& context);
  static std::string meaning() { return "fronts of slip that are narrower than cells resolve"; }

  // Looks at the end of a step. Warns the first time that the zone has fewer cells than
  // scenario::fewest_cells_of_front, and again when it has half as many as at the last warning.
  void note(dynamics::WatchedState const& now, dynamics::Notes& notes) override;

  // Empty if friction fell nowhere.
  std::string report() const override;

  void save(Archive& archive) const override;
  void restore(Archive const& archive, Restart const&) override;

private:
  std::optional<dynamics::FrontZone> zone_;
  dynamics::Fault const& fault_;
  double cells_ = std::numeric_limits<double>::infinity(); // fewest so far
  double length_ = 0, time_ = 0;                           // of that zone [m], [s]
  std::array<double, 3> place_{};                          // [m]
  double warned_cells_ = std::numeric_limits<double>::infinity();
};
} // namespace asperity::scenario
