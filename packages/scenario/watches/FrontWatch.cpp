#include "scenario/watches/FrontWatch.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "scenario/checks/ResolutionCheck.hpp"

#include <limits>
#include <utility>

namespace asperity::scenario
{
FrontWatch::FrontWatch(ParameterList const&, dynamics::WatchContext const& context)
    : zone_(context.zone)
    , fault_(context.fault)
{
}

void FrontWatch::note(dynamics::WatchedState const& now, dynamics::Notes& notes)
{
  if (!zone_ || !now.step) {
    return;
  }
  auto const found =
    zone_->narrowest(fault_.state(), now.sample.slipRates(), fault_.given(now.state));
  if (!found || found->cells >= cells_) {
    return;
  }
  cells_ = found->cells;
  length_ = found->length;
  time_ = now.time;
  std::array<double, 3> mine;
  mine.fill(std::numeric_limits<double>::lowest());
  place_ = maxOverRanks(found->node >= 0 ? fault_.surface()[found->node].place : mine,
                        *fault_.surface().communicator());
  if (cells_ >= fewest_cells_of_front || cells_ > warned_cells_ / 2) {
    return;
  }
  warned_cells_ = cells_;
  notes.add(warnOfFront(cells_, "at t = " + formatShort(time_) + " s, " +
                                  formatPoint({place_[0], place_[1], place_[2]})));
}

std::string FrontWatch::report() const
{
  if (!(cells_ < std::numeric_limits<double>::infinity())) {
    return "";
  }
  return "Friction fell fastest at t = " + formatShort(time_) + " s, " +
         formatPoint({place_[0], place_[1], place_[2]}) + ": over a zone of " +
         formatShort(length_) + " m, " + formatShort(cells_) + " cells.\n";
}

void FrontWatch::save(Archive& archive) const
{
  if (!(cells_ < std::numeric_limits<double>::infinity())) {
    return;
  }
  archive.set("cells", cells_);
  archive.set("length", length_);
  archive.set("time", time_);
  archive.set("told", warned_cells_);
  for (int k = 0; k < 3; ++k) {
    archive.set("place_" + std::to_string(k), place_[k]);
  }
}

void FrontWatch::restore(Archive const& archive, Restart const&)
{
  if (!archive.has("cells")) {
    return;
  }
  cells_ = archive.getDouble("cells");
  length_ = archive.getDouble("length");
  time_ = archive.getDouble("time");
  warned_cells_ = archive.getDouble("told"); // the restart has repeated that warning
  for (int k = 0; k < 3; ++k) {
    place_[k] = archive.getDouble("place_" + std::to_string(k));
  }
}
} // namespace asperity::scenario

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "front_watch",
                  asperity::dynamics::WatchKindOf<asperity::scenario::FrontWatch>)
