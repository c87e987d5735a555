#pragma once

#include "dynamics/watches/SlowSlip.hpp"
#include "dynamics/watches/Watch.hpp"

namespace asperity::dynamics
{
// Warns of steps that hide a growing slip rate: earthquakes may be lost in them. The peak slip rate
// V at the end of such a step is more than twice that before it, and
// - V dt > L / 10 in a forced step, which does not meet the tolerance even at the smallest size, or
//   has a prescribed size. V is compared with the smallest rate in the present sequence of forced
//   steps, from the beginning of the first of them.
// - V dt > L in a step that meets the tolerance, which then is too loose.
// The two kinds are counted apart. So are steps that slip by more than 2 L where friction weakens
// and slip is slow (SlowSlip), in which a growth that is damped cannot show; they never end a run.
class GrowthWatch : public Watch
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning() { return "steps in which an earthquake may be lost"; }

  // slip_distance: L [m], the smallest of the fault; 0 if unknown: then growth alone counts in
  // steps that do not meet the tolerance, and other steps are not judged.
  // most: the number of forced, or of other steps that hide growth at which the run ends; 0 means
  // no limit, which is always so for prescribed steps: all of them are forced.
  GrowthWatch(double slip_distance, std::int64_t most, bool is_prescribed = false)
      : slip_distance_(slip_distance)
      , most_(is_prescribed ? 0 : most)
      , is_prescribed_(is_prescribed)
  {
  }
  GrowthWatch(Teuchos::ParameterList const& parameters, WatchContext const& context);

  struct Step
  {
    bool is_forced = false;
    double time = 0;        // at its end [s]
    double step_size = 0;   // [s]
    double rate_before = 0; // peak slip rate [m/s]
    double rate = 0;        // the same at its end
    double slow_slip = 0;   // SlowSlip::largestRatio [-]
  };
  // Returns a warning for the 1st, 10th, 100th, ... step that hides growth, and for number `most`.
  std::optional<Warning> note(Step const& step);
  // Looks at nothing where no state of the fault decides: prescribed slip rates may grow.
  void note(WatchedState const& now, Notes& notes) override;
  // Throws UselessRun if `most` steps of one kind have hidden growth.
  void requireUsefulRun() const override;

  void save(Archive& archive) const override;
  // Counts go on, so that restarts do not escape the limits. What has been cured is counted anew:
  // forced steps where the smallest step is smaller than before, others where the tolerance is. The
  // largest step cannot change, so that levels tell sizes.
  void restore(Archive const& archive, Restart const& restart) override;

  // What a restart goes on from.
  struct Memory
  {
    double least = -1; // rate since forced steps began; negative after a step that is not forced
    std::int64_t forced = 0; // steps that hid growth
    std::int64_t others = 0;
    std::int64_t damped = 0; // steps that slipped by more than 2 L
  };
  Memory const& memory() const { return memory_; }

private:
  bool isForced(Step const& step) const { return step.is_forced || is_prescribed_; }
  bool hidesGrowth(Step const& step);
  std::string describe(Step const& step, std::int64_t count) const;
  std::optional<Warning> noteSlowSlip(Step const& step);

  struct Slow
  {
    Fault const& fault;
    SlowSlip slip;
  };

  double slip_distance_;
  double tolerance_ = 0; // of the step control; 0 if it has none
  std::optional<Slow> slow_;
  std::int64_t most_;
  bool is_prescribed_;
  Memory memory_;
  std::string last_description_; // of the last step that hid growth, without a full stop
};
} // namespace asperity::dynamics
