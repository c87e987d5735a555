#include "catalogue/fault_geometry/FaultAxis.hpp"

#include "base/parallel/Reductions.hpp"
#include "fem/constraints/PlaneTangent.hpp"
#include "io/parallel/BlocksInOrder.hpp"
#include "io/parallel/NodeBlocks.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::catalogue
{
FaultAxis faultAxis(io::OutputDomain const& fault)
{
  std::vector<double> ends(5, 0.); // x and y of the first node; x, y and position of the last one
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    double const* x = &fault.coordinates[2 * i];
    if (fault.node_numbers[i] == 0) {
      std::copy(x, x + 2, ends.begin());
    }
    if (fault.node_numbers[i] == fault.num_global_nodes - 1) {
      std::copy(x, x + 2, ends.begin() + 2);
      ends[4] = fault.positions[i];
    }
  }
  ends = sumOverRanks(ends, *fault.comm); // others have zeros
  FaultAxis axis{{ends[0], ends[1]}, {ends[2], ends[3]}, ends[4]};
  const double run = axis.upper[0] - axis.lower[0], rise = axis.upper[1] - axis.lower[1];
  const double extent = std::hypot(run, rise);
  axis.is_level = std::abs(rise) <= io::equally_high * extent;
  axis.tangent_rises = !axis.is_level && fem::tangentInPlane(-rise / extent, run / extent)[1] > 0;
  return axis;
}

std::optional<std::array<double, 2>> pointAlong(io::OutputDomain const& fault, double distance)
{
  const io::NodeBlocks blocks(fault);
  const auto coordinates = io::joinedInOrder(fault, blocks(fault.coordinates, 1, 2));
  const auto distances = io::joinedInOrder(fault, blocks(fault.positions, 1, 1));
  constexpr double rounding = 1e-9;
  double found[3] = {0, 0, 0}; // a flag and the point
  for (std::size_t i = 1; i < distances.size(); ++i) {
    const double length = distances[i] - distances[i - 1];
    const double part = (distance - distances[i - 1]) / length;
    if (part >= -rounding && part <= 1 + rounding) {
      found[0] = 1;
      for (int d = 0; d < 2; ++d) {
        found[1 + d] = (1 - part) * coordinates[2 * (i - 1) + d] + part * coordinates[2 * i + d];
      }
    }
  }
  Teuchos::broadcast(*fault.comm, 0, 3, found);
  return found[0] > 0 ? std::optional(std::array<double, 2>{found[1], found[2]}) : std::nullopt;
}
} // namespace asperity::catalogue
