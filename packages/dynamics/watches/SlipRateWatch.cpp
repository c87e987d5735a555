#include "dynamics/checks/PlausibleValues.hpp"
#include "dynamics/watches/Watch.hpp"

namespace asperity::dynamics
{
namespace
{
// Warns of slip rates beyond what the model describes; again at ten times the last one.
class SlipRateWatch : public Watch
{
public:
  static std::string meaning() { return "slip rates that no rock has"; }

  SlipRateWatch(Teuchos::ParameterList const&, WatchContext const& context)
      : largest_(context.largest_slip_rate)
      , next_warning_(largest_)
  {
  }

  void note(WatchedState const& now, Notes& notes) override
  {
    const double rate = now.sample.peakSlipRate();
    if (rate > next_warning_) {
      next_warning_ = 10 * rate;
      notes.warnings.push_back(warnOfSlipRate(rate, largest_));
    }
  }

private:
  double largest_, next_warning_; // [m/s]
};
} // namespace
} // namespace asperity::dynamics

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "slip_rate_watch",
                  asperity::dynamics::WatchKindOf<asperity::dynamics::SlipRateWatch>)
