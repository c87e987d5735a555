#pragma once

#include "catalogue/events/Event.hpp"
#include "catalogue/events/EventEnergies.hpp"
#include "catalogue/events/EventFollower.hpp"
#include "catalogue/events/EventSettings.hpp"
#include "catalogue/fault_geometry/FaultPlane.hpp"
#include "io/Output.hpp"
#include "io/files/TextTable.hpp"

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
class EventCatalogue : public EventFollower
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::string neededDomain() { return "fault"; }
  static std::vector<std::string> files() { return {"events.csv", "events_*.csv"}; }

  // InputError if `Each Fault` is true and there is a single one.
  EventCatalogue(Teuchos::ParameterList const& parameters, io::OutputContext const& context);
  EventCatalogue(EventCatalogue const&) = delete; // those of its faults refer to this object
  EventCatalogue& operator=(EventCatalogue const&) = delete;

  void write(io::StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override;
  bool endsRun() const override { return mayEndRun() && numComplete() >= settings_.most_events; }
  bool mayEndRun() const override { return settings_.most_events > 0; }
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

  std::optional<std::int64_t> numEvents() const override;
  // A table of the events, their summary, and a sentence if the threshold hides earthquakes.
  std::string report() const override;

  // Known on every rank: complete events, and after finish() the one then in progress.
  std::vector<Event> const& events() const { return events_; }
  EventSummary summary() const { return summarise(events_); }

protected:
  void begin(Sample const& now) override;
  void follow(Sample const& now) override;
  void end(Sample const& now) override;

private:
  // Of one boundary of the fault `whole`, if that is not null.
  EventCatalogue(EventSettings const& settings, io::OutputContext const& context,
                 EventCatalogue const* whole, std::optional<int> boundary, std::string const& file);

  // What a sample has besides the rates; set before EventFollower::write.
  struct More
  {
    std::vector<double> slip; // (num_owned, components) [m]
    std::vector<double> energies;
  };

  Event measure(double end_time, bool complete) const;
  template <class Coordinate>
  double extent(Coordinate const& coordinate) const; // of the nodes that have ruptured
  double const* place(std::size_t i) const { return &fault().coordinates[3 * i]; }
  bool isSmall(Event const& event) const;
  std::string onThreshold() const; // for report()
  std::int64_t numComplete() const { return static_cast<std::int64_t>(events_.size()); }
  void recordLast();                         // when no further event can be part of it
  std::vector<double> choice() const;        // what a restart has to find unchanged
  double peakSince(Sample const& now) const; // [m/s] around the previous sample, of all nodes

  EventSettings settings_;
  EventCatalogue const* whole_;
  std::vector<std::unique_ptr<EventCatalogue>> faults_; // written after this one
  io::OutputField const& slip_;
  EventEnergies energies_;
  std::optional<FaultPlane> plane_;   // of a surface
  std::vector<double> shear_modulus_; // (num_owned) [Pa]
  io::TextTable file_;
  std::vector<Event> events_;
  std::int64_t num_events_ = 0; // also those that are parts of others, or small
  std::int64_t num_small_ = 0;  // without a row
  double largest_rate_ = 0;     // [m/s] of all samples
  bool is_seismic_throughout_ = true;

  More now_, before_;
  Event open_;         // onset, first node and peak rate of the event in progress
  Sample earlier_;     // the one before the previous one; no rates in the first step of an event
  Event last_;         // the one that ended last,
  bool waits_ = false; // while another one may become part of it
  std::vector<double> energies_at_begin_, energies_at_end_;
  std::vector<double> seismic_slip_;   // (num_owned) [m]
  std::vector<std::int64_t> ruptured_; // (num_owned) 1 where the node reached the threshold
};
} // namespace asperity::catalogue
