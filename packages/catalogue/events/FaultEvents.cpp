#include "catalogue/events/FaultEvents.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "catalogue/events/EventTable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace asperity::catalogue
{
namespace
{
using Numbers = std::vector<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

Numbers numbersOf(Event const& event, std::size_t dimension)
{
  Numbers numbers;
  appendNumbers(event, dimension, numbers);
  return numbers;
}

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
  if (waiting_ && step.time - waiting_->event.end >= settings_.merging_time) {
    recordWaiting();
  }
  std::swap(before_, now_);
}

void FaultEvents::begin(Sample const& now)
{
  older_sample_ = Sample();
  const double onset = crossingTime(now);
  if (waiting_ && onset - waiting_->event.end < settings_.merging_time) {
    waiting_.reset(); // that event goes on
    ++num_events_;
    return;
  }
  if (waiting_) {
    recordWaiting();
  }
  in_progress_ = EventInProgress();
  auto& event = in_progress_.event;
  event.onset = onset;
  ++num_events_;
  event.number = all_faults_ ? all_faults_->in_progress_.event.number : num_events_;
  // If the very first sample is seismic, the fastest node counts as the first one.
  std::vector<double> lateness(fault().numOwned(), infinity);
  for (std::size_t i = 0; i < lateness.size(); ++i) {
    if (now.rates[i] >= threshold()) {
      lateness[i] =
        hasPrevious() ? crossing(previous().rates[i], now.rates[i], threshold()) : -now.rates[i];
    }
  }
  const auto first = firstNode(fault(), lateness);
  event.nucleation = first.position;
  event.hypocentre = first.coordinates;
  in_progress_.energies_at_begin = hasPrevious() ? before_.energies : now_.energies;
  in_progress_.seismic_slip.assign(fault().numOwned(), 0);
  in_progress_.ruptured.assign(fault().numOwned(), 0);
}

void FaultEvents::follow(Sample const& now)
{
  auto& event = in_progress_.event;
  event.peak_slip_rate = std::max({event.peak_slip_rate, now.peak, peakSince(now)});
  const std::size_t components = slip_.components;
  for (std::size_t i = 0; i < fault().numOwned(); ++i) {
    if (now.rates[i] >= threshold()) {
      in_progress_.ruptured[i] = 1;
    }
    if (hasPrevious()) {
      double square = 0;
      for (std::size_t k = i * components; k < (i + 1) * components; ++k) {
        square += (now_.slip[k] - before_.slip[k]) * (now_.slip[k] - before_.slip[k]);
      }
      in_progress_.seismic_slip[i] +=
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
  waiting_ = WaitingEvent{measure(crossingTime(now), true), now_.energies};
}

Event FaultEvents::measure(double end_time, bool complete) const
{
  double area = 0, moment = 0;
  for (std::size_t i = 0; i < fault().numOwned(); ++i) {
    area += in_progress_.ruptured[i] ? fault().weights[i] : 0;
    moment += fault().weights[i] * shear_modulus_[i] * in_progress_.seismic_slip[i];
  }
  auto const& comm = *fault().comm;
  Event event = in_progress_.event;
  event.end = end_time;
  event.peak_slip = maxOverRanks(largest(in_progress_.seismic_slip), comm);
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
    if (in_progress_.ruptured[i]) {
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

void FaultEvents::recordWaiting()
{
  auto const [event, energies_at_end] = *std::exchange(waiting_, std::nullopt);
  if (isSmall(event)) {
    ++num_small_;
    return;
  }
  events_.push_back(event);
  file_.writeRow(eventRow(event) +
                 energies_.columns(in_progress_.energies_at_begin, energies_at_end));
  file_.flush(); // events are rare, and users wait for them
}

void FaultEvents::closeSegment(int) { file_.flush(); }

void FaultEvents::finish()
{
  if (eventInProgress()) {
    waiting_ = WaitingEvent{measure(previous().time, false), before_.energies};
    stop();
  }
  if (waiting_) {
    recordWaiting();
  }
  file_.flush();
}

std::optional<std::int64_t> FaultEvents::numEvents() const
{
  const bool one_more = eventInProgress() || waiting_;
  return static_cast<std::int64_t>(events_.size()) + one_more;
}

std::string FaultEvents::thresholdRemark() const
{
  const std::string entry = " 'Event Catalogue / Threshold' = " + formatShort(threshold()) + " m/s";
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

Archive FaultEvents::EventInProgress::save(io::OutputDomain const& fault) const
{
  Archive archive;
  archive.set("event", numbersOf(event, fault.dimension));
  archive.set("energies_at_begin", energies_at_begin);
  archive.setAtNodes("seismic_slip", seismic_slip, fault.name);
  archive.setAtNodes("ruptured", ruptured, fault.name);
  return archive;
}

void FaultEvents::EventInProgress::restore(Archive const& archive, std::size_t dimension)
{
  event = eventFrom(archive.get<Numbers>("event").data(), dimension);
  energies_at_begin = archive.get<Numbers>("energies_at_begin");
  seismic_slip = archive.get<Numbers>("seismic_slip");
  ruptured = archive.get<std::vector<std::int64_t>>("ruptured");
}

Archive FaultEvents::WaitingEvent::save(io::OutputDomain const& fault) const
{
  Archive archive;
  archive.set("event", numbersOf(event, fault.dimension));
  archive.set("energies_at_end", energies_at_end);
  return archive;
}

void FaultEvents::WaitingEvent::restore(Archive const& archive, std::size_t dimension)
{
  event = eventFrom(archive.get<Numbers>("event").data(), dimension);
  energies_at_end = archive.get<Numbers>("energies_at_end");
}

void FaultEvents::save(Archive& archive) const
{
  Archive follower;
  EventFollower::save(follower);
  archive.insert("follower", follower);
  archive.insert("file", file_);
  Numbers numbers;
  for (auto const& event : events_) {
    appendNumbers(event, fault().dimension, numbers);
  }
  archive.set("events", numbers);
  archive.set("num_events", num_events_);
  archive.set("num_small", num_small_);
  archive.set("largest_rate", largest_rate_);
  archive.set("is_seismic_throughout", is_seismic_throughout_);
  archive.insert("in_progress", in_progress_.save(fault()));
  if (waiting_) {
    archive.insert("waiting", waiting_->save(fault()));
  }
  archive.set("older_sample/time", older_sample_.time);
  archive.setAtNodes("older_sample/rates", older_sample_.rates, fault().name);
  archive.setAtNodes("before/slip", before_.slip, fault().name);
  archive.set("before/energies", before_.energies);
}

void FaultEvents::restore(Archive const& archive)
{
  EventFollower::restore(archive.child("follower"));
  file_.restore(archive.child("file"));
  const std::size_t dimension = fault().dimension;
  auto const& numbers = archive.get<Numbers>("events");
  events_.clear();
  for (std::size_t i = 0; i < numbers.size(); i += numbersOfEvent(dimension)) {
    events_.push_back(eventFrom(&numbers[i], dimension));
  }
  num_events_ = archive.getInteger("num_events");
  num_small_ = archive.getInteger("num_small");
  largest_rate_ = archive.getDouble("largest_rate");
  is_seismic_throughout_ = archive.getInteger("is_seismic_throughout") != 0;
  in_progress_.restore(archive.child("in_progress"), dimension);
  waiting_.reset();
  if (archive.has("waiting/event")) {
    waiting_.emplace().restore(archive.child("waiting"), dimension);
  }
  older_sample_.time = archive.getDouble("older_sample/time");
  older_sample_.rates = archive.get<Numbers>("older_sample/rates");
  before_.slip = archive.get<Numbers>("before/slip");
  before_.energies = archive.get<Numbers>("before/energies");
}
} // namespace asperity::catalogue
