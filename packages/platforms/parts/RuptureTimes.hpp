#pragma once

#include "catalogue/events/Rupture.hpp"
#include "catalogue/fault_geometry/FaultPlaces.hpp"
#include "io/parallel/NodeBlocks.hpp"
#include "platforms/PlatformFiles.hpp"

#include <string>

namespace asperity::platforms
{
// When the rupture first reached each node of the fault, with its place along strike and down dip.
class RuptureTimes : public Part
{
public:
  // `name` is that of the file, "cplot"; `fields` names its columns, "j k t".
  RuptureTimes(Platform const& platform, io::OutputContext const& context, std::string name,
               std::string fields, catalogue::Rupture const& rupture);

  void write(io::StepInfo const&) override {}
  void flush(StepFacts const& steps) override;
  void save(io::Archive&) const override {} // the file is written as a whole
  void restore(io::Archive const&) override {}

private:
  std::string header() const;
  double never() const; // the time [s] of nodes that the rupture has not reached

  Platform platform_;
  std::string name_, fields_;
  std::filesystem::path directory_;
  RCP<const Communicator> comm_;
  catalogue::Rupture const& rupture_;
  bool is_curve_;     // the fault, in two dimensions
  double final_time_; // of the run [s]
  catalogue::FaultPlaces places_;
  io::NodeBlocks blocks_;
};
} // namespace asperity::platforms
