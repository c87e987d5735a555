#pragma once

#include "io/platforms/PlatformColumns.hpp"
#include "io/platforms/PlatformFile.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::io::detail
{
// The time series of the stations on the fault, or of those in the body, as a platform takes them.
// SEAS: a row for each call of write. SCEC: rows at equal distances from time 0 on, interpolated
// linearly between the calls, which should be all accepted steps.
class PlatformStations
{
public:
  struct Station
  {
    std::string file;     // "fltst_dp075"
    std::string location; // for the header
  };

  PlatformStations(TextFormat const& format, std::filesystem::path const& directory,
                   std::vector<Station> const& stations, PlatformColumns const& columns,
                   RCP<const Communicator> const& comm);

  PlatformColumns const& columns() const { return columns_; }

  // sampled: (num_stations, components) by field, on rank 0.
  void write(double time, std::map<std::string, std::vector<double>> const& sampled);

  // What a restart must find unchanged, or the rows of one file would not fit together.
  std::string signature() const;

  // `steps` are those of the run.
  void flush(StepFacts const& steps);
  void save(Archive& archive) const;
  void restore(Archive const& archive);

private:
  using Rows = std::vector<double>; // (num_stations, num_columns)
  void writeRows(double time, Rows const& rows);

  TextFormat format_;
  PlatformColumns columns_;
  std::vector<PlatformSeries> files_;

  std::int64_t num_rows_ = 0; // SCEC: the next one is at num_rows_ times the time step
  double previous_time_ = 0;
  Rows previous_;
};
} // namespace asperity::io::detail
