#pragma once

#include "catalogue/events/Global.hpp"
#include "platforms/PlatformFiles.hpp"

namespace asperity::platforms
{
// global.dat: log10 of the peak slip rate and the moment rate, with the rows of global.csv.
class GlobalSeries : public Part
{
public:
  GlobalSeries(Platform const& platform, io::OutputContext const& context,
               catalogue::Global const& global);

  void write(io::StepInfo const& step) override;
  void flush(StepFacts const& steps) override { file_.flush(steps); }
  void save(io::Archive& archive) const override { file_.save(archive); }
  void restore(io::Archive const& archive) override { file_.restore(archive); }

private:
  catalogue::Global const& global_;
  TimeSeries file_;
};
} // namespace asperity::platforms
