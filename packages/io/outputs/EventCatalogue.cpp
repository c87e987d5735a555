#include "io/outputs/EventCatalogue.hpp"

#include "base/Parameters.hpp"
#include "io/detail/Gather.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::io
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
  const double at = detail::crossing(before, after, threshold);
  return after >= threshold ? 1 - at : at;
}

double largest(std::vector<double> const& values)
{
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

constexpr char const* columns =
  "number,onset [s],end [s],duration [s],width [m],peak_slip [m],peak_slip_rate [m/s],"
  "moment_per_length [N],nucleation [m],complete";

// An event as numbers, for the checkpoint.
constexpr std::size_t numbers_per_event = 8;

void appendNumbers(Event const& event, std::vector<double>& numbers)
{
  numbers.insert(numbers.end(),
                 {event.onset, event.end, event.width, event.peak_slip, event.peak_slip_rate,
                  event.moment, event.nucleation, event.complete ? 1.0 : 0.0});
}

Event eventFrom(double const* numbers)
{
  return {numbers[0], numbers[1], numbers[2], numbers[3],
          numbers[4], numbers[5], numbers[6], numbers[7] != 0};
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> EventCatalogue::validParameters()
{
  return Declare()
    .boolean("Enabled", true, "Whether to write this output.")
    .real("Threshold", 1e-3, "m/s", Range::positive(),
          "Slip rate from which on a node is seismic; an event is a contiguous time in which some "
          "node is.")
    .list();
}

std::string EventCatalogue::meaning() { return "One row for every earthquake: events.csv."; }

EventCatalogue::EventCatalogue(Teuchos::ParameterList const& parameters,
                               OutputContext const& context)
    : fault_(context.location("fault"))
    , rates_(fault_, context.fields)
    , slip_(context.fields.field("fault", "slip"))
    , energies_(context.fields)
    , threshold_(parameters.get<double>("Threshold"))
    , file_(context.directory / "events.csv", columns + energies_.header(), context.comm)
{
  ASPERITY_REQUIRE(fault_.isCurve(), "Output / Event Catalogue: the fault is not a curve. Set "
                                     "`Enabled` to false.");
  context.fields.field("fault", "shear_modulus").values(shear_modulus_);
}

EventCatalogue::Sample EventCatalogue::sample(StepInfo const& step) const
{
  Sample now;
  now.time = step.time;
  auto rates = rates_.sample();
  now.slip_rate = std::move(rates.rates);
  now.peak_slip_rate = rates.peak;
  slip_.values(now.slip);
  now.energies = energies_.sample();
  return now;
}

void EventCatalogue::write(StepInfo const& step)
{
  Sample now = sample(step);
  const bool is_seismic = now.peak_slip_rate >= threshold_;
  if (is_seismic && !in_progress_) {
    begin(now);
  }
  if (in_progress_) {
    accumulate(now);
    if (!is_seismic) {
      end(now);
    }
  }
  previous_ = std::move(now);
  has_previous_ = true;
}

void EventCatalogue::begin(Sample const& now)
{
  in_progress_ = true;
  open_ = Event();
  open_.onset = now.time;
  if (has_previous_) {
    const double at = detail::crossing(previous_.peak_slip_rate, now.peak_slip_rate, threshold_);
    open_.onset = previous_.time + at * (now.time - previous_.time);
  }
  open_.nucleation = nucleationPosition(now);
  energies_before_ = has_previous_ ? previous_.energies : now.energies;
  seismic_slip_.assign(fault_.numOwned(), 0);
  ruptured_.assign(fault_.numOwned(), 0);
}

// Of the node that meets the threshold first, between the samples; of the fastest node if the very
// first sample is seismic. Among equals the one nearest to the first end.
double EventCatalogue::nucleationPosition(Sample const& now) const
{
  std::vector<double> lateness(fault_.numOwned(), infinity);
  for (std::size_t i = 0; i < lateness.size(); ++i) {
    if (now.slip_rate[i] >= threshold_) {
      lateness[i] = has_previous_
                      ? detail::crossing(previous_.slip_rate[i], now.slip_rate[i], threshold_)
                      : -now.slip_rate[i];
    }
  }
  double mine = infinity;
  for (const double value : lateness) {
    mine = std::min(mine, value);
  }
  const double first = detail::minOverRanks(mine, *fault_.comm);
  double position = infinity;
  for (std::size_t i = 0; i < lateness.size(); ++i) {
    if (lateness[i] == first) {
      position = std::min(position, fault_.positions[i]);
    }
  }
  return detail::minOverRanks(position, *fault_.comm);
}

void EventCatalogue::accumulate(Sample const& now)
{
  open_.peak_slip_rate = std::max(open_.peak_slip_rate, now.peak_slip_rate);
  const std::size_t components = slip_.components;
  for (std::size_t i = 0; i < fault_.numOwned(); ++i) {
    if (now.slip_rate[i] >= threshold_) {
      ruptured_[i] = 1;
    }
    if (has_previous_) {
      double square = 0;
      for (std::size_t k = i * components; k < (i + 1) * components; ++k) {
        square += (now.slip[k] - previous_.slip[k]) * (now.slip[k] - previous_.slip[k]);
      }
      seismic_slip_[i] +=
        seismicFraction(previous_.slip_rate[i], now.slip_rate[i], threshold_) * std::sqrt(square);
    }
  }
}

void EventCatalogue::end(Sample const& now)
{
  const double at = detail::crossing(previous_.peak_slip_rate, now.peak_slip_rate, threshold_);
  record(measure(previous_.time + at * (now.time - previous_.time), true), now.energies);
  in_progress_ = false;
}

Event EventCatalogue::measure(double end_time, bool complete) const
{
  double first = infinity, last = -infinity, moment = 0;
  for (std::size_t i = 0; i < fault_.numOwned(); ++i) {
    if (ruptured_[i]) {
      first = std::min(first, fault_.positions[i]);
      last = std::max(last, fault_.positions[i]);
    }
    moment += fault_.weights[i] * shear_modulus_[i] * seismic_slip_[i];
  }
  auto const& comm = *fault_.comm;
  Event event = open_;
  event.end = end_time;
  event.width = detail::maxOverRanks(last, comm) - detail::minOverRanks(first, comm);
  event.peak_slip = detail::maxOverRanks(largest(seismic_slip_), comm);
  event.moment = detail::sumOverRanks(moment, comm);
  event.complete = complete;
  return event;
}

void EventCatalogue::record(Event const& event, std::vector<double> const& energies)
{
  events_.push_back(event);
  std::string row = std::to_string(events_.size());
  for (const double time : {event.onset, event.end}) {
    row += ',' + exactNumber(time);
  }
  for (const double value : {event.duration(), event.width, event.peak_slip, event.peak_slip_rate,
                             event.moment, event.nucleation}) {
    row += ',' + shortNumber(value);
  }
  row += event.complete ? ",1" : ",0";
  file_.writeRow(row + energies_.columns(energies_before_, energies));
}

void EventCatalogue::closeSegment(int) { file_.flush(); }

void EventCatalogue::finish()
{
  if (in_progress_) {
    record(measure(previous_.time, false), previous_.energies);
    in_progress_ = false;
  }
  file_.flush();
}

void EventCatalogue::save(Archive& archive) const
{
  std::vector<double> numbers, open;
  for (auto const& event : events_) {
    appendNumbers(event, numbers);
  }
  appendNumbers(open_, open);
  archive.set("events", numbers);
  archive.set("in_progress", in_progress_);
  archive.set("open_event", open);
  archive.set("seismic_slip", seismic_slip_);
  archive.set("ruptured", ruptured_);
  archive.set("previous/exists", has_previous_);
  archive.set("previous/time", previous_.time);
  archive.set("previous/peak_slip_rate", previous_.peak_slip_rate);
  archive.set("previous/slip_rate", previous_.slip_rate);
  archive.set("previous/slip", previous_.slip);
  archive.set("previous/energies", previous_.energies);
  archive.set("energies_before", energies_before_);
  Archive file;
  file_.save(file);
  archive.insert("file", file);
}

void EventCatalogue::restore(Archive const& archive)
{
  using Numbers = std::vector<double>;
  auto const& numbers = archive.get<Numbers>("events");
  events_.clear();
  for (std::size_t i = 0; i + numbers_per_event <= numbers.size(); i += numbers_per_event) {
    events_.push_back(eventFrom(numbers.data() + i));
  }
  in_progress_ = archive.getInteger("in_progress") != 0;
  open_ = eventFrom(archive.get<Numbers>("open_event").data());
  seismic_slip_ = archive.get<Numbers>("seismic_slip");
  ruptured_ = archive.get<std::vector<std::int64_t>>("ruptured");
  has_previous_ = archive.getInteger("previous/exists") != 0;
  previous_.time = archive.getDouble("previous/time");
  previous_.peak_slip_rate = archive.getDouble("previous/peak_slip_rate");
  previous_.slip_rate = archive.get<Numbers>("previous/slip_rate");
  previous_.slip = archive.get<Numbers>("previous/slip");
  previous_.energies = archive.get<Numbers>("previous/energies");
  energies_before_ = archive.get<Numbers>("energies_before");
  file_.restore(archive.child("file"));
}

ASPERITY_REGISTER(OutputRegistry, "Event Catalogue", OutputKindOf<EventCatalogue>)
} // namespace asperity::io
