#pragma once

#include "dynamics/watches/Watch.hpp"

namespace asperity::dynamics
{
// Notes that a run hardly advances, because all its steps have the smallest size: a line of the log
// for the 100th, 1000th, ... step in a row, and a warning if these steps do not meet the tolerance.
class StallWatch : public Watch
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning() { return "many steps in a row that do not meet the tolerance"; }

  // most_forced: the number of forced steps in a row at which the run ends; 0 means no limit.
  explicit StallWatch(std::int64_t most_forced) : most_forced_(most_forced) {}
  StallWatch(Teuchos::ParameterList const& parameters, WatchContext const& context);

  void note(WatchedState const& now, Notes& notes) override;
  struct Step
  {
    bool is_smallest = false;
    bool is_forced = false; // accepted above the tolerance
    double time = 0;        // [s]
    double step_size = 0;   // [s]
    double time_left = 0;   // to the end of the run [s]
  };
  void note(Step const& step, Notes& notes);
  // Throws SolveError at the limit most_forced.
  void requireUsefulRun() const override;

  void save(Archive& archive) const override;
  // Counts go on, unless the smallest step is smaller than before.
  void restore(Archive const& archive, Restart const& restart) override;

private:
  std::int64_t most_forced_;
  std::int64_t smallest_ = 0, forced_ = 0; // steps in a row
  std::optional<Step> last_;               // none since the start or restart
};
} // namespace asperity::dynamics
