// A watch of your own: warns once slip is so long that small strains do not describe the body.
// dynamics/watches/Watch.hpp says what a watch has to have.
#include "base/parallel/Reductions.hpp"
#include "dynamics/watches/Watch.hpp"
#include "parameters/Entries.hpp"

#include <algorithm>
#include <cmath>

namespace
{
using namespace asperity;
using namespace asperity::dynamics;

class LargeSlip : public Watch
{
public:
  // Its entries are in the deck's list `Time Stepping`.
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters() { return entries().list(); }
  static std::string meaning() { return "slip above 'Largest Slip'"; }

  LargeSlip(Teuchos::ParameterList const& parameters, WatchContext const& context)
      : largest_(entries().read(parameters, parameters.name()).slip)
      , communicator_(context.fault.surface().communicator())
  {
  }

  void note(WatchedState const& now, Notes& notes) override
  {
    double mine = 0;
    for (const double component : now.sample.slip()) {
      mine = std::max(mine, std::abs(component));
    }
    const double slip = maxOverRanks(mine, *communicator_);
    if (slip > largest_ && !has_warned_) {
      has_warned_ = true;
      notes.add(Warning{"large slip", "The fault has slipped by " + std::to_string(1e3 * slip) +
                                        " mm, which is much for this body."});
    }
  }

  void save(Archive& archive) const override { archive.set("has_warned", has_warned_); }
  void restore(Archive const& archive, Restart const&) override
  {
    has_warned_ = archive.has("has_warned") && archive.getInteger("has_warned") != 0;
  }

private:
  struct Settings
  {
    double slip = 2e-4; // [m]
  };
  static Entries<Settings> entries()
  {
    return Entries<Settings>().real("Largest Slip", &Settings::slip, "m", Range::positive(),
                                    "The run warns once the fault has slipped by more than this.");
  }

  double largest_; // [m]
  RCP<const Communicator> communicator_;
  bool has_warned_ = false;
};
} // namespace

ASPERITY_REGISTER(WatchRegistry, "large_slip", WatchKindOf<LargeSlip>)
