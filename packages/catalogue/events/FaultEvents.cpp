#include "catalogue/events/FaultEvents.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "catalogue/events/EventTable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace asperity::catalogue
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

// The part of the time between two samples during which the rate is at least the threshold.
double seismicFraction(double before, double after, double threshold)
{
  if (before >= threshold && after >= threshold) {
    return 1;
  }
  if (before < threshold && after < threshold) {
    return 0;
  }
  const double at = crossing(before, after, threshold);
  return after >= threshold ? 1 - at : at;
}

double largest(std::vector<double> const& values)
{
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}
} // namespace

FaultEvents::FaultEvents(EventSettings const& settings, io::OutputContext const& context,
                         std::string const& file, FaultEvents const* whole,
                         std::optional<int> boundary)
    : EventFollower(context, settings.threshold, boundary)
    , settings_(settings)
    , all_faults_(whole)
    , slip_(context.fields.field("fault", "slip"))
    , energies_(whole ? EventEnergies() : EventEnergies(context.fields))
    , file_(context.directory / file, eventColumns(!fault().isCurve()) + energies_.header(),
            context.comm)
{
  context.fields.field("fault", "shear_modulus").values(shear_modulus_);
  if (!fault().isCurve()) {
    plane_ = faultPlane(fault(), context.up, boundary);
  }
}

void FaultEvents::write(io::StepInfo const& step)
{
  slip_.values(now_.slip);
  now_.energies = energies_.sample();
  EventFollower::write(step);
  largest_rate_ = std::max(largest_rate_, previous().peak);
  is_seismic_throughout_ = is_seismic_throughout_ && eventInProgress();
  if (may_merge_ && step.time - last_event_.end >= settings_.merging_time) {
    recordLast();
  }
  std::swap(before_, now_);
}

void FaultEvents::begin(Sample const& now)
{
  older_sample_ = Sample();
  const double onset = crossingTime(now);
  if (may_merge_ && onset - last_event_.end < settings_.merging_time) {
    may_merge_ = false; // the event before goes on
    ++num_events_;
    return;
  }
  if (may_merge_) {
    recordLast();
  }
  current_event_ = Event();
  current_event_.onset = onset;
  ++num_events_;
  current_event_.number = all_faults_ ? all_faults_->current_event_.number : num_events_;
  // If the very first sample is seismic, the fastest node counts as the first one.
  std::vector<double> lateness(fault().numOwned(), infinity);
  for (std::size_t i = 0; i < lateness.size(); ++i) {
    if (now.rates[i] >= threshold()) {
      lateness[i] =
        hasPrevious() ? crossing(previous().rates[i], now.rates[i], threshold()) : -now.rates[i];
    }
  }
  const auto first = firstNode(fault(), lateness);
  current_event_.nucleation = first.position;
  current_event_.hypocentre = first.coordinates;
  energies_at_begin_ = hasPrevious() ? before_.energies : now_.energies;
  seismic_slip_.assign(fault().numOwned(), 0);
  ruptured_.assign(fault().numOwned(), 0);
}

void FaultEvents::follow(Sample const& now)
{
  current_event_.peak_slip_rate =
    std::max({current_event_.peak_slip_rate, now.peak, peakSince(now)});
  const std::size_t components = slip_.components;
  for (std::size_t i = 0; i < fault().numOwned(); ++i) {
    if (now.rates[i] >= threshold()) {
      ruptured_[i] = 1;
    }
    if (hasPrevious()) {
      double square = 0;
      for (std::size_t k = i * components; k < (i + 1) * components; ++k) {
        square += (now_.slip[k] - before_.slip[k]) * (now_.slip[k] - before_.slip[k]);
      }
      seismic_slip_[i] +=
        seismicFraction(previous().rates[i], now.rates[i], threshold()) * std::sqrt(square);
    }
  }
  if (hasPrevious()) {
    older_sample_ = previous();
  }
}

double FaultEvents::peakSince(Sample const& now) const
{
  double largest = 0;
  for (std::size_t i = 0; i < older_sample_.rates.size(); ++i) {
    largest =
      std::max(largest, peakRate({older_sample_.time, previous().time, now.time},
                                 {older_sample_.rates[i], previous().rates[i], now.rates[i]}));
  }
  return maxOverRanks(largest, *fault().comm);
}

void FaultEvents::end(Sample const& now)
{
  last_event_ = measure(crossingTime(now), true);
  energies_at_end_ = now_.energies;
  may_merge_ = true;
}

Event FaultEvents::measure(double end_time, bool complete) const
{
  double area = 0, moment = 0;
  for (std::size_t i = 0; i < fault().numOwned(); ++i) {
    area += ruptured_[i] ? fault().weights[i] : 0;
    moment += fault().weights[i] * shear_modulus_[i] * seismic_slip_[i];
  }
  auto const& comm = *fault().comm;
  Event event = current_event_;
  event.end = end_time;
  event.peak_slip = maxOverRanks(largest(seismic_slip_), comm);
  event.moment = sumOverRanks(moment, comm);
  event.complete = complete;
  if (plane_) {
    event.area = sumOverRanks(area, comm);
    event.length = extent([this](std::size_t i) { return plane_->alongStrike(place(i)); });
    event.width = extent([this](std::size_t i) { return plane_->downDip(place(i)); });
  } else {
    event.width = extent([this](std::size_t i) { return fault().positions[i]; });
  }
  return event;
}

template <class Coordinate>
double FaultEvents::extent(Coordinate const& coordinate) const
{
  double first = infinity, last = -infinity;
  for (std::size_t i = 0; i < fault().numOwned(); ++i) {
    if (ruptured_[i]) {
      first = std::min(first, coordinate(i));
      last = std::max(last, coordinate(i));
    }
  }
  auto const& comm = *fault().comm;
  return maxOverRanks(last, comm) - minOverRanks(first, comm);
}

bool FaultEvents::isSmall(Event const& event) const
{
  return event.width < settings_.smallest_width ||
         (settings_.smallest_magnitude > EventSettings::no_magnitude &&
          event.magnitude() < settings_.smallest_magnitude);
}

void FaultEvents::recordLast()
{
  may_merge_ = false;
  if (isSmall(last_event_)) {
    ++num_small_;
    return;
  }
  events_.push_back(last_event_);
  file_.writeRow(eventRow(last_event_) + energies_.columns(energies_at_begin_, energies_at_end_));
  file_.flush(); // events are rare, and users wait for them
}

void FaultEvents::closeSegment(int) { file_.flush(); }

void FaultEvents::finish()
{
  if (eventInProgress()) {
    last_event_ = measure(previous().time, false);
    energies_at_end_ = before_.energies;
    may_merge_ = true;
    stop();
  }
  if (may_merge_) {
    recordLast();
  }
  file_.flush();
}

std::optional<std::int64_t> FaultEvents::numEvents() const
{
  const bool one_more = eventInProgress() || may_merge_;
  return static_cast<std::int64_t>(events_.size()) + one_more;
}

std::string FaultEvents::thresholdRemark() const
{
  std::string const& entry =
    " 'Event Catalogue / Threshold' = " + formatShort(threshold()) + " m/s";
  if (num_events_ == 0 && largest_rate_ > 0) {
    return "No event: the largest slip rate, " + formatShort(largest_rate_) + " m/s, is below" +
           entry + ".\n";
  }
  if (is_seismic_throughout_ && largest_rate_ > 0) {
    return "The fault slips above" + entry +
           " at all times, so that all is one event. Choose one above the rates of creep.\n";
  }
  return "";
}

void FaultEvents::save(Archive& archive) const
{
  Archive follower;
  EventFollower::save(follower);
  archive.insert("follower", follower);
  archive.insert("file", file_);
  std::vector<double> numbers, open, last;
  for (auto const& event : events_) {
    appendNumbers(event, fault().dimension, numbers);
  }
  appendNumbers(current_event_, fault().dimension, open);
  appendNumbers(last_event_, fault().dimension, last);
  archive.set("num_events", num_events_);
  archive.set("num_small", num_small_);
  archive.set("last_event", last);
  archive.set("last_waits", may_merge_);
  archive.set("largest_rate", largest_rate_);
  archive.set("seismic_throughout", is_seismic_throughout_);
  archive.set("energies_at_end", energies_at_end_);
  archive.set("events", numbers);
  archive.set("open_event", open);
  archive.setAtNodes("seismic_slip", seismic_slip_, fault().name);
  archive.setAtNodes("ruptured", ruptured_, fault().name);
  archive.set("energies_at_begin", energies_at_begin_);
  archive.set("earlier/time", older_sample_.time);
  archive.setAtNodes("earlier/rates", older_sample_.rates, fault().name);
  archive.setAtNodes("before/slip", before_.slip, fault().name);
  archive.set("before/energies", before_.energies);
}

void FaultEvents::restore(Archive const& archive)
{
  using Numbers = std::vector<double>;
  EventFollower::restore(archive.child("follower"));
  file_.restore(archive.child("file"));
  const std::size_t dimension = fault().dimension;
  auto const& numbers = archive.get<Numbers>("events");
  events_.clear();
  for (std::size_t i = 0; i < numbers.size(); i += numbersOfEvent(dimension)) {
    events_.push_back(eventFrom(&numbers[i], dimension));
  }
  current_event_ = eventFrom(archive.get<Numbers>("open_event").data(), dimension);
  last_event_ = eventFrom(archive.get<Numbers>("last_event").data(), dimension);
  num_events_ = archive.getInteger("num_events");
  num_small_ = archive.getInteger("num_small");
  may_merge_ = archive.getInteger("last_waits") != 0;
  const bool knows_rates = archive.has("largest_rate"); // not of versions before: no sentence then
  largest_rate_ = knows_rates ? archive.getDouble("largest_rate") : 0;
  is_seismic_throughout_ = knows_rates && archive.getInteger("seismic_throughout") != 0;
  energies_at_end_ = archive.get<Numbers>("energies_at_end");
  seismic_slip_ = archive.get<Numbers>("seismic_slip");
  ruptured_ = archive.get<std::vector<std::int64_t>>("ruptured");
  energies_at_begin_ = archive.get<Numbers>("energies_at_begin");
  older_sample_.time = archive.getDouble("earlier/time");
  older_sample_.rates = archive.get<Numbers>("earlier/rates");
  before_.slip = archive.get<Numbers>("before/slip");
  before_.energies = archive.get<Numbers>("before/energies");
}

} // namespace asperity::catalogue
