#include "catalogue/events/EventFollower.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>

namespace asperity::catalogue
{
EventFollower::EventFollower(io::OutputContext const& context, double threshold,
                             std::optional<int> boundary)
    : fault_(context.domain("fault"))
    , slip_rate_(context.fields.field("fault", "slip_rate"))
    , counts_(countedNodes(context))
    , threshold_(threshold)
    , is_of_boundary_(boundary.has_value())
{
  for (std::size_t i = 0; boundary && i < counts_.size(); ++i) {
    counts_[i] *= fault_.node_boundaries[i] == *boundary ? 1 : 0;
  }
}

void EventFollower::write(io::StepInfo const& step)
{
  Sample now{step.time, step.peak_slip_rate, {}};
  slip_rate_.values(now.rates);
  for (std::size_t i = 0; i < now.rates.size(); ++i) {
    now.rates[i] *= counts_[i];
  }
  if (is_of_boundary_) {
    now.peak = now.rates.empty() ? 0 : *std::max_element(now.rates.begin(), now.rates.end());
    now.peak = maxOverRanks(now.peak, *fault_.comm);
  }
  const bool is_seismic = now.peak >= threshold_;
  if (is_seismic && !in_progress_) {
    in_progress_ = true;
    begin(now);
  }
  if (in_progress_) {
    follow(now);
    if (!is_seismic) {
      end(now);
      in_progress_ = false;
    }
  }
  previous_ = std::move(now);
  has_previous_ = true;
}

double EventFollower::crossingTime(Sample const& now) const
{
  if (!has_previous_) {
    return now.time;
  }
  const double at = crossing(previous_.peak, now.peak, threshold_);
  return previous_.time + at * (now.time - previous_.time);
}

double EventFollower::crossingTime(Sample const& now, std::size_t i) const
{
  if (!has_previous_) {
    return now.time;
  }
  const double at = crossing(previous_.rates[i], now.rates[i], threshold_);
  return previous_.time + at * (now.time - previous_.time);
}

void EventFollower::save(Archive& archive) const
{
  archive.set("threshold", threshold_);
  archive.set("in_progress", in_progress_);
  archive.set("previous/exists", has_previous_);
  archive.set("previous/time", previous_.time);
  archive.set("previous/peak", previous_.peak);
  archive.setAtNodes("previous/rates", previous_.rates, fault_.name);
}

void EventFollower::restore(Archive const& archive)
{
  const double before = archive.getDouble("threshold");
  ASPERITY_REQUIRE(before == threshold_,
                   "The checkpoint is of a run whose events begin at "
                     << before << " m/s, and the deck's Threshold is now " << threshold_
                     << " m/s. Restart with the same one, or begin a new run.");
  in_progress_ = archive.getInteger("in_progress") != 0;
  has_previous_ = archive.getInteger("previous/exists") != 0;
  previous_.time = archive.getDouble("previous/time");
  previous_.peak = archive.getDouble("previous/peak");
  previous_.rates = archive.get<std::vector<double>>("previous/rates");
}

FirstNode firstNode(io::OutputDomain const& fault, std::vector<double> const& lateness)
{
  const double infinity = std::numeric_limits<double>::infinity();
  auto const& comm = *fault.comm;
  double earliest = infinity;
  for (const double value : lateness) {
    earliest = std::min(earliest, value);
  }
  earliest = minOverRanks(earliest, comm);
  double mine = infinity; // numbers are exact in a double
  std::size_t node = 0;
  for (std::size_t i = 0; i < lateness.size(); ++i) {
    const auto number = static_cast<double>(fault.node_numbers[i]);
    if (lateness[i] == earliest && number < mine) {
      mine = number;
      node = i;
    }
  }
  const double least = minOverRanks(mine, comm);
  const bool is_here = mine == least && mine < infinity;
  FirstNode first;
  for (int d = 0; d < fault.dimension; ++d) {
    const double value = is_here ? fault.coordinates[node * fault.dimension + d] : 0;
    first.coordinates.push_back(sumOverRanks(value, comm));
  }
  if (fault.isCurve()) {
    first.position = sumOverRanks(is_here ? fault.positions[node] : 0, comm);
  }
  return first;
}
} // namespace asperity::catalogue
