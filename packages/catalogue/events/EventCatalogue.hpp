#pragma once

#include "catalogue/events/Event.hpp"
#include "catalogue/events/EventSettings.hpp"
#include "catalogue/events/FaultEvents.hpp"
#include "io/Output.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// DIR/events.csv: one row an event.
//
// Needs the fields `slip_rate`, `slip` (of any number of components) and `shear_modulus` on the
// domain `fault`. A node's slip counts while the node itself is at or above the threshold
// (Pipping 2014, §5.4: the displacement at the base that occurs at seismic velocities). The peak
// slip rate is that of a node between steps (peakRate), since no step need end at the peak. On a
// surface an event has an area, a moment and a magnitude, a hypocentre, and extents along strike
// and down dip of the fault's mean plane; on a curve a width and a moment per length. Events that
// follow one another within `Merging Time` are one, from the first onset to the last end; smaller
// ones than the deck asks for have no row.
//
// `Each Fault` adds DIR/events_<boundary>.csv for each boundary that the fault is made of: the same
// of its nodes alone and without energies. A row has the number of the event of events.csv that
// this fault takes part in; there may be several. On a surface extents are in its own mean plane.
class EventCatalogue : public io::Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::string neededDomain() { return "fault"; }
  static std::vector<std::string> files() { return {"events.csv", "events_*.csv"}; }

  // InputError if `Each Fault` is true and there is a single one.
  EventCatalogue(Teuchos::ParameterList const& parameters, io::OutputContext const& context);
  EventCatalogue(EventCatalogue const&) = delete; // each of `faults_` refers to `all_`
  EventCatalogue& operator=(EventCatalogue const&) = delete;

  void write(io::StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override;
  bool endsRun() const override;
  bool mayEndRun() const override { return settings_.most_events > 0; }
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

  std::optional<std::int64_t> numEvents() const override { return all_.numEvents(); }
  // A table of the events, their summary, and a sentence if the threshold hides earthquakes.
  std::string report() const override;

  bool eventInProgress() const { return all_.eventInProgress(); }
  // Known on every rank: complete events, and after finish() the one then in progress.
  std::vector<Event> const& events() const { return all_.events(); }
  EventSummary summary() const { return summarise(events()); }

private:
  EventCatalogue(EventSettings const& settings, io::OutputContext const& context);

  std::vector<double> signature() const; // what a restart has to find unchanged

  EventSettings settings_;
  FaultEvents all_;                                  // of all nodes of the fault
  std::vector<std::unique_ptr<FaultEvents>> faults_; // of each boundary; written after `all_`
};
} // namespace asperity::catalogue
