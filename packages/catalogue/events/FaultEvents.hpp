#pragma once

#include "catalogue/events/Event.hpp"
#include "catalogue/events/EventEnergies.hpp"
#include "catalogue/events/EventFollower.hpp"
#include "catalogue/events/EventSettings.hpp"
#include "catalogue/fault_geometry/FaultPlane.hpp"
#include "io/files/TextTable.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// The events of all nodes of the fault, or of those of one of its boundaries, and their table.
// EventCatalogue says what counts as an event and what is measured of it.
class FaultEvents : public EventFollower
{
public:
  // Of the boundary of this number, whose rows have the numbers of the events of `whole`, without
  // energies; of all nodes, with energies, if there is none. `file`: the name of the table.
  FaultEvents(EventSettings const& settings, io::OutputContext const& context,
              std::string const& file, FaultEvents const* whole = nullptr,
              std::optional<int> boundary = {});

  void write(io::StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override;
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;
  std::optional<std::int64_t> numEvents() const override;

  // Known on every rank: complete events, and after finish() the one then in progress.
  std::vector<Event> const& events() const { return events_; }
  std::int64_t numSmall() const { return num_small_; } // events without a row
  // A line about the threshold, if the table shows no earthquake because of it; else "".
  std::string thresholdRemark() const;
  io::OutputDomain const& domain() const { return fault(); }

protected:
  void begin(Sample const& now) override;
  void follow(Sample const& now) override;
  void end(Sample const& now) override;

private:
  // What a sample has besides the rates; set before EventFollower::write.
  struct SlipAndEnergies
  {
    std::vector<double> slip; // (num_owned, components) [m]
    std::vector<double> energies;
  };

  // The event in progress; after its end it stays, since the event may go on within the merging
  // time.
  struct EventInProgress
  {
    Event event; // onset, first node and number; peak rate so far
    std::vector<double> energies_at_begin;
    std::vector<double> seismic_slip;   // (num_owned) [m]
    std::vector<std::int64_t> ruptured; // (num_owned) 1 where the node reached the threshold

    Archive save(io::OutputDomain const& fault) const;
    void restore(Archive const& archive, std::size_t dimension);
  };
  // An event that has ended and waits for its row: the next one may be a part of it.
  struct WaitingEvent
  {
    Event event;
    std::vector<double> energies_at_end;

    Archive save(io::OutputDomain const& fault) const;
    void restore(Archive const& archive, std::size_t dimension);
  };

  Event measure(double end_time, bool complete) const;
  template <class Coordinate>
  double extent(Coordinate const& coordinate) const; // of the nodes that have ruptured
  double const* place(std::size_t i) const { return &fault().coordinates[3 * i]; }
  bool isSmall(Event const& event) const;
  void recordWaiting();                      // when no further event can be part of it
  double peakSince(Sample const& now) const; // [m/s] around the previous sample, of all nodes

  EventSettings settings_;
  FaultEvents const* all_faults_;
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

  SlipAndEnergies now_, before_;
  Sample older_sample_; // the one before the previous one; no rates in the first step of an event
  EventInProgress in_progress_;
  std::optional<WaitingEvent> waiting_;
};
} // namespace asperity::catalogue
