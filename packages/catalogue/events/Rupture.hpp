#pragma once

#include "catalogue/events/EventFollower.hpp"
#include "io/series/SegmentedTable.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// DIR/rupture.h5: when each node of the fault first reached a slip rate, in each event and in the
// run. Needs `slip_rate` on the fault.
class Rupture : public EventFollower
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  static std::string neededDomain() { return "fault"; }
  static std::vector<std::string> files() { return {"rupture.h5"}; }

  Rupture(Teuchos::ParameterList const& parameters, io::OutputContext const& context);
  Rupture(Rupture const&) = delete; // the table refers to this object
  Rupture& operator=(Rupture const&) = delete;

  void closeSegment(int index) override { table_.closeSegment(index); }
  void finish() override;
  void save(Archive& archive) const override;
  void restore(Archive const& archive) override;

protected:
  void begin(Sample const& now) override;
  void follow(Sample const& now) override;
  void end(Sample const& now) override;

private:
  io::SegmentedTable::Options tableOptions(std::filesystem::path const& directory);
  void addRow();

  io::SegmentedTable table_;

  std::int64_t num_events_ = 0;    // that have ended
  double onset_ = 0;               // [s]
  std::vector<double> event_time_; // (num_owned) [s] in the event in progress
  std::vector<double> first_time_; // (num_owned) [s]
};
} // namespace asperity::catalogue
