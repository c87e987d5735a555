#include "catalogue/events/EventCatalogue.hpp"

#include "base/parallel/Reductions.hpp"
#include "base/parameters/Parameters.hpp"

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

std::string columns(bool on_surface)
{
  const std::string times = "number,onset [s],end [s],duration [s],";
  if (on_surface) {
    return times + "area [m^2],length [m],width [m],peak_slip [m],peak_slip_rate [m/s],"
                   "moment [N m],magnitude,hypocentre_x [m],hypocentre_y [m],hypocentre_z [m],"
                   "complete";
  }
  return times + "width [m],peak_slip [m],peak_slip_rate [m/s],moment_per_length [N],"
                 "nucleation [m],complete";
}

// An event as numbers, for the checkpoint: these and the hypocentre.
constexpr std::size_t numbers_of_event = 10;

void appendNumbers(Event const& event, std::size_t dimension, std::vector<double>& numbers)
{
  numbers.insert(numbers.end(), {event.onset, event.end, event.width, event.peak_slip,
                                 event.peak_slip_rate, event.moment, event.nucleation,
                                 event.complete ? 1.0 : 0.0, event.area, event.length});
  auto hypocentre = event.hypocentre;
  hypocentre.resize(dimension, 0);
  numbers.insert(numbers.end(), hypocentre.begin(), hypocentre.end());
}

Event eventFrom(double const* numbers, std::size_t dimension)
{
  double const* hypocentre = numbers + numbers_of_event;
  return {numbers[0],
          numbers[1],
          numbers[2],
          numbers[3],
          numbers[4],
          numbers[5],
          numbers[6],
          numbers[7] != 0,
          numbers[8],
          numbers[9],
          {hypocentre, hypocentre + dimension}};
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> EventCatalogue::validParameters()
{
  return Declare()
    .boolean("Enabled", true, "If true, the run writes this output.")
    .real("Threshold", 1e-3, "m/s", Range::positive(),
          "A node is seismic while its slip rate is at least this. An event lasts as long as some "
          "node is seismic.")
    .list();
}

std::string EventCatalogue::meaning()
{
  return "Writes one row for every earthquake to events.csv.";
}

EventCatalogue::EventCatalogue(Teuchos::ParameterList const& parameters,
                               io::OutputContext const& context)
    : EventFollower(context, parameters.get<double>("Threshold"))
    , slip_(context.fields.field("fault", "slip"))
    , energies_(context.fields)
    , file_(context.directory / "events.csv", columns(!fault().isCurve()) + energies_.header(),
            context.comm)
{
  context.fields.field("fault", "shear_modulus").values(shear_modulus_);
  if (!fault().isCurve()) {
    plane_ = faultPlane(fault(), context.up);
  }
}

void EventCatalogue::write(io::StepInfo const& step)
{
  slip_.values(now_.slip);
  now_.energies = energies_.sample();
  EventFollower::write(step);
  std::swap(before_, now_);
}

void EventCatalogue::begin(Sample const& now)
{
  open_ = Event();
  open_.onset = crossingTime(now);
  // If the very first sample is seismic, the fastest node counts as the first one.
  std::vector<double> lateness(fault().numOwned(), infinity);
  for (std::size_t i = 0; i < lateness.size(); ++i) {
    if (now.rates[i] >= threshold()) {
      lateness[i] =
        hasPrevious() ? crossing(previous().rates[i], now.rates[i], threshold()) : -now.rates[i];
    }
  }
  const auto first = firstNode(fault(), lateness);
  open_.nucleation = first.position;
  open_.hypocentre = first.coordinates;
  earlier_ = Sample();
  energies_at_begin_ = hasPrevious() ? before_.energies : now_.energies;
  seismic_slip_.assign(fault().numOwned(), 0);
  ruptured_.assign(fault().numOwned(), 0);
}

void EventCatalogue::follow(Sample const& now)
{
  open_.peak_slip_rate = std::max({open_.peak_slip_rate, now.peak, peakSince(now)});
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
    earlier_ = previous();
  }
}

double EventCatalogue::peakSince(Sample const& now) const
{
  double largest = 0;
  for (std::size_t i = 0; i < earlier_.rates.size(); ++i) {
    largest = std::max(largest, peakRate({earlier_.time, previous().time, now.time},
                                         {earlier_.rates[i], previous().rates[i], now.rates[i]}));
  }
  return maxOverRanks(largest, *fault().comm);
}

void EventCatalogue::end(Sample const& now)
{
  record(measure(crossingTime(now), true), now_.energies);
}

Event EventCatalogue::measure(double end_time, bool complete) const
{
  double area = 0, moment = 0;
  for (std::size_t i = 0; i < fault().numOwned(); ++i) {
    area += ruptured_[i] ? fault().weights[i] : 0;
    moment += fault().weights[i] * shear_modulus_[i] * seismic_slip_[i];
  }
  auto const& comm = *fault().comm;
  Event event = open_;
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
double EventCatalogue::extent(Coordinate const& coordinate) const
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

void EventCatalogue::record(Event const& event, std::vector<double> const& energies)
{
  events_.push_back(event);
  std::string row = std::to_string(events_.size());
  for (const double time : {event.onset, event.end}) {
    row += ',' + io::exactNumber(time);
  }
  std::vector<double> values{event.duration()};
  if (plane_) {
    values.insert(values.end(), {event.area, event.length, event.width, event.peak_slip,
                                 event.peak_slip_rate, event.moment, event.magnitude()});
    values.insert(values.end(), event.hypocentre.begin(), event.hypocentre.end());
  } else {
    values.insert(values.end(), {event.width, event.peak_slip, event.peak_slip_rate, event.moment,
                                 event.nucleation});
  }
  for (const double value : values) {
    row += ',' + io::shortNumber(value);
  }
  row += event.complete ? ",1" : ",0";
  file_.writeRow(row + energies_.columns(energies_at_begin_, energies));
  file_.flush(); // rare, and waited for
}

void EventCatalogue::closeSegment(int) { file_.flush(); }

void EventCatalogue::finish()
{
  if (eventInProgress()) {
    record(measure(previous().time, false), before_.energies);
    stop();
  }
  file_.flush();
}

std::vector<io::Count> EventCatalogue::counts() const
{
  return {{static_cast<std::int64_t>(events_.size()) + eventInProgress(), "event"}};
}

std::string EventCatalogue::report() const
{
  std::ostringstream text;
  printEvents(text, events_);
  text << '\n';
  printSummary(text, summary());
  text << '\n';
  return text.str();
}

void EventCatalogue::save(io::Archive& archive) const
{
  io::Archive follower, file;
  EventFollower::save(follower);
  file_.save(file);
  archive.insert("follower", follower);
  archive.insert("file", file);
  std::vector<double> numbers, open;
  for (auto const& event : events_) {
    appendNumbers(event, fault().dimension, numbers);
  }
  appendNumbers(open_, fault().dimension, open);
  archive.set("events", numbers);
  archive.set("open_event", open);
  archive.setAtNodes("seismic_slip", seismic_slip_, fault().name);
  archive.setAtNodes("ruptured", ruptured_, fault().name);
  archive.set("energies_at_begin", energies_at_begin_);
  archive.set("earlier/time", earlier_.time);
  archive.setAtNodes("earlier/rates", earlier_.rates, fault().name);
  archive.setAtNodes("before/slip", before_.slip, fault().name);
  archive.set("before/energies", before_.energies);
}

void EventCatalogue::restore(io::Archive const& archive)
{
  using Numbers = std::vector<double>;
  EventFollower::restore(archive.child("follower"));
  file_.restore(archive.child("file"));
  const std::size_t dimension = fault().dimension;
  auto const& numbers = archive.get<Numbers>("events");
  events_.clear();
  for (std::size_t i = 0; i < numbers.size(); i += numbers_of_event + dimension) {
    events_.push_back(eventFrom(&numbers[i], dimension));
  }
  open_ = eventFrom(archive.get<Numbers>("open_event").data(), dimension);
  seismic_slip_ = archive.get<Numbers>("seismic_slip");
  ruptured_ = archive.get<std::vector<std::int64_t>>("ruptured");
  energies_at_begin_ = archive.get<Numbers>("energies_at_begin");
  earlier_.time = archive.getDouble("earlier/time");
  earlier_.rates = archive.get<Numbers>("earlier/rates");
  before_.slip = archive.get<Numbers>("before/slip");
  before_.energies = archive.get<Numbers>("before/energies");
}

ASPERITY_REGISTER(io::OutputRegistry, "Event Catalogue", io::OutputKindOf<EventCatalogue>)
} // namespace asperity::catalogue
