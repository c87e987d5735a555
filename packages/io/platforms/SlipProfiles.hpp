#pragma once

#include "io/Output.hpp"
#include "io/catalogue/events/FaultRates.hpp"
#include "io/parallel/NodeGather.hpp"
#include "io/platforms/PlatformFile.hpp"

namespace asperity::io::detail
{
// DIR/seas/slip.dat: slip along the fault at the times of the fault's history, as the platform for
// sequences of earthquakes takes it. A row has the time, log10 of the peak slip rate and the slip
// at every node, from the upper end of the fault down.
class SlipProfiles
{
public:
  explicit SlipProfiles(OutputContext const& context);

  void write(StepInfo const& step);
  void flush(StepFacts const& steps) { file_.flush(steps); }
  void save(Archive& archive) const { file_.save(archive); }
  void restore(Archive const& archive) { file_.restore(archive); }

private:
  NodeGather gather_;
  FaultRates rates_;
  Field const& slip_;
  bool is_reversed_; // the upper end is the last node
  PlatformSeries file_;
};
} // namespace asperity::io::detail
