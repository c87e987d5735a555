#pragma once

#include "catalogue/receivers/Receivers.hpp"
#include "platforms/PlatformFiles.hpp"
#include "platforms/parts/Columns.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::platforms
{
// The time series of the stations on the fault, or of those in the body: a file for each receiver.
// A row for each row of receivers.h5 or, with a row distance, rows at equal distances from time 0
// on, interpolated linearly between all accepted steps.
class Stations : public Part
{
public:
  struct Kind
  {
    std::string prefix; // of the files' names, "fltst_"
    std::string where;  // for the header, "on fault"
    Columns columns;
    double row_distance = 0; // [s]; 0: rows as in receivers.h5
  };

  // `group` is one of those of the receivers, which must outlive the stations.
  Stations(Platform const& platform, io::OutputContext const& context, Kind kind,
           catalogue::Receivers const& receivers, catalogue::ReceiverGroup const& group);

  void write(io::StepInfo const& step) override;
  void flush(StepFacts const& steps) override;
  void save(io::Archive& archive) const override;
  void restore(io::Archive const& archive) override;

private:
  using Rows = std::vector<double>; // (num_stations, num_columns)
  Rows sample() const;
  void writeRowsUntil(double time, Rows const& now);
  void writeRows(double time, Rows const& rows);

  std::string platform_; // its name
  Kind kind_;
  catalogue::Receivers const& receivers_;
  catalogue::ReceiverGroup const& group_;
  std::vector<io::OutputField const*> fields_; // of the columns
  std::vector<TimeSeries> files_;

  std::int64_t num_rows_ = 0; // at equal distances: the next one is at num_rows_ times the distance
  double previous_time_ = 0;
  Rows previous_;
};

// Adds the stations on the fault and those in the body, as far as there are receivers, with what
// the two functions make of the view of the model. Collective.
using KindOf = std::function<Stations::Kind(ModelView const&)>;
void addStations(PlatformFiles& files, Platform const& platform, io::OutputContext const& context,
                 catalogue::Receivers const& receivers, KindOf const& on_fault,
                 KindOf const& in_body);
} // namespace asperity::platforms
