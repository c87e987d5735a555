#include "scenario/run/FrontWatch.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "scenario/report/ResolutionCheck.hpp"

#include <limits>
#include <utility>

namespace asperity::scenario
{
FrontWatch::FrontWatch(std::optional<dynamics::FrontZone> zone, dynamics::Fault const& fault)
    : zone_(std::move(zone))
    , fault_(fault)
{
}

std::optional<Warning> FrontWatch::note(dynamics::State const& now,
                                        dynamics::FaultSample const& sample, double time)
{
  if (!zone_) {
    return std::nullopt;
  }
  auto const found = zone_->narrowest(fault_.state(), sample.slipRates(), fault_.given(now));
  if (!found || found->cells >= cells_) {
    return std::nullopt;
  }
  cells_ = found->cells;
  length_ = found->length;
  time_ = time;
  std::array<double, 3> mine;
  mine.fill(std::numeric_limits<double>::lowest());
  place_ = maxOverRanks(found->node >= 0 ? fault_.surface()[found->node].place : mine,
                        *fault_.surface().communicator());
  if (cells_ >= fewest_cells_of_front || cells_ > told_ / 2) {
    return std::nullopt;
  }
  told_ = cells_;
  return warnOfFront(cells_, "at t = " + formatShort(time) + " s, " +
                               formatPoint({place_[0], place_[1], place_[2]}));
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

void FrontWatch::save(io::Archive& archive, std::string const& path) const
{
  if (!(cells_ < std::numeric_limits<double>::infinity())) {
    return;
  }
  archive.set(path + "cells", cells_);
  archive.set(path + "length", length_);
  archive.set(path + "time", time_);
  archive.set(path + "told", told_);
  for (int k = 0; k < 3; ++k) {
    archive.set(path + "place_" + std::to_string(k), place_[k]);
  }
}

void FrontWatch::restore(io::Archive const& archive, std::string const& path)
{
  if (!archive.has(path + "cells")) {
    return;
  }
  cells_ = archive.getDouble(path + "cells");
  length_ = archive.getDouble(path + "length");
  time_ = archive.getDouble(path + "time");
  told_ = archive.getDouble(path + "told"); // the restart has repeated that warning
  for (int k = 0; k < 3; ++k) {
    place_[k] = archive.getDouble(path + "place_" + std::to_string(k));
  }
}
} // namespace asperity::scenario
