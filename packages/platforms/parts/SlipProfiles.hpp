#pragma once

#include "io/outputs/FieldHistory.hpp"
#include "io/parallel/NodeBlocks.hpp"
#include "platforms/PlatformFiles.hpp"
#include "platforms/parts/Columns.hpp"

namespace asperity::platforms
{
// slip.dat: slip along a fault that is a curve, at the times of the fault's history. A row has the
// time, log10 of the peak slip rate and the slip at every node, from the upper end of the fault
// down.
class SlipProfiles : public Part
{
public:
  SlipProfiles(Platform const& platform, io::OutputContext const& context,
               io::FaultHistory const& history);

  void write(io::StepInfo const& step) override;
  void flush(StepFacts const& steps) override { file_.flush(steps); }
  void save(io::Archive& archive) const override { file_.save(archive); }
  void restore(io::Archive const& archive) override { file_.restore(archive); }

private:
  io::FaultHistory const& history_;
  io::OutputDomain const& fault_;
  io::NodeBlocks blocks_;
  io::OutputField const& slip_;
  double sign_; // of the slip in the file
  TimeSeries file_;
};
} // namespace asperity::platforms
