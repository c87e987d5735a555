#include "io/catalogue/fault_geometry/FaultAxis.hpp"

#include "io/parallel/Gather.hpp"
#include "io/parallel/NodeGather.hpp"

#include <cmath>

namespace asperity::io::detail
{
FaultAxis faultAxis(Location const& fault)
{
  const NodeGather gather(fault);
  const auto coordinates = gather(fault.coordinates, 1, fault.dimension);
  FaultAxis axis;
  axis.distances = gather(fault.positions, 1, 1);
  double first_y = 0, last_y = 0, length = 0;
  if (!axis.distances.empty()) {
    first_y = coordinates[1];
    last_y = coordinates.back();
    length = axis.distances.back();
    if (last_y > first_y) {
      for (double& distance : axis.distances) {
        distance = length - distance;
      }
    }
  }
  const double level = std::abs(last_y - first_y) <= 1e-9 * length ? 1 : 0;
  axis.is_level = maxOverRanks(fault.comm->getRank() == 0 ? level : 0, *fault.comm) > 0;
  return axis;
}
} // namespace asperity::io::detail
