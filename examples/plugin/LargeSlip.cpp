// A watch of your own: warns once slip is longer than a share of the body, where small strains do
// not describe it. dynamics/watches/Watch.hpp says what a watch has to have.
#include "base/parallel/Reductions.hpp"
#include "dynamics/watches/Watch.hpp"

#include <algorithm>
#include <cmath>

namespace
{
using namespace asperity;
using namespace asperity::dynamics;

constexpr double largest_slip = 2e-4; // m, for a body of about a metre

class LargeSlip : public Watch
{
public:
  explicit LargeSlip(WatchContext const& context)
      : communicator_(context.fault.surface().communicator())
  {
  }

  void note(WatchedState const& now, Notes& notes) override
  {
    double mine = 0;
    for (const double component : now.sample.slip()) {
      mine = std::max(mine, std::abs(component));
    }
    const double slip = maxOverRanks(mine, *communicator_);
    if (slip > largest_slip && !has_warned_) {
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
  RCP<const Communicator> communicator_;
  bool has_warned_ = false;
};
} // namespace

ASPERITY_REGISTER(WatchRegistry, "large_slip", WatchKindOf<LargeSlip>)
