#pragma once

#include "io/Event.hpp"
#include "io/Output.hpp"
#include "io/TextTable.hpp"
#include "io/detail/EventEnergies.hpp"
#include "io/detail/FaultRates.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::io
{
// DIR/events.csv: one row an event; nothing is merged.
//
// Needs the fields `slip_rate`, `slip` and `shear_modulus` on the location `fault`, a curve. Onset
// and end are interpolated linearly in the logarithm of the peak slip rate between accepted steps.
// A node's slip counts while the node itself is at or above the threshold (Pipping 2014, §5.4: the
// displacement at the base that occurs at seismic velocities); nodes whose slip rate is prescribed
// do not count.
class EventCatalogue : public Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();

  EventCatalogue(Teuchos::ParameterList const& parameters, OutputContext const& context);

  void write(StepInfo const& step) override;
  void closeSegment(int index) override;
  void finish() override;
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

  // Known on every rank: complete events, and after finish() the one then in progress.
  std::vector<Event> const& events() const { return events_; }
  bool eventInProgress() const { return in_progress_; }
  EventSummary summary() const { return summarise(events_); }

private:
  struct Sample
  {
    double time = 0;
    double peak_slip_rate = 0;
    std::vector<double> slip_rate; // (num_owned)
    std::vector<double> slip;      // (num_owned, components)
    std::vector<double> energies;
  };

  Sample sample(StepInfo const& step) const;
  void begin(Sample const& now);
  void accumulate(Sample const& now);
  void end(Sample const& now);
  Event measure(double end_time, bool complete) const;
  double nucleationPosition(Sample const& now) const;
  void record(Event const& event, std::vector<double> const& energies); // at its end

  Location const& fault_;
  detail::FaultRates rates_;
  Field const& slip_;
  detail::EventEnergies energies_;
  double threshold_;                  // [m/s]
  std::vector<double> shear_modulus_; // (num_owned) [Pa]
  TextTable file_;
  std::vector<Event> events_;

  bool has_previous_ = false;
  Sample previous_;

  bool in_progress_ = false;
  Event open_; // onset, nucleation and peak rate of the event in progress
  std::vector<double> energies_before_;
  std::vector<double> seismic_slip_;   // (num_owned) [m]
  std::vector<std::int64_t> ruptured_; // (num_owned) 1 where the node reached the threshold
};
} // namespace asperity::io
