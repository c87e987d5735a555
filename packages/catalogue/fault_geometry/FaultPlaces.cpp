#include "catalogue/fault_geometry/FaultPlaces.hpp"

#include "base/parallel/Reductions.hpp"
#include "io/parallel/NodeGather.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <cmath>

namespace asperity::catalogue
{
FaultAxis faultAxis(io::OutputDomain const& fault)
{
  std::vector<double> ends{0, 0, 0}; // y of the first node, y and position of the last one
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    if (fault.node_numbers[i] == 0) {
      ends[0] = fault.coordinates[2 * i + 1];
    }
    if (fault.node_numbers[i] == fault.num_global_nodes - 1) {
      ends[1] = fault.coordinates[2 * i + 1];
      ends[2] = fault.positions[i];
    }
  }
  ends = sumOverRanks(ends, *fault.comm); // others have zeros
  const double first_y = ends[0], last_y = ends[1], length = ends[2];
  FaultAxis axis;
  axis.distances = fault.positions;
  axis.rises = last_y > first_y;
  if (axis.rises) {
    for (double& distance : axis.distances) {
      distance = length - distance;
    }
  }
  axis.is_level = std::abs(last_y - first_y) <= 1e-9 * length;
  return axis;
}

std::optional<std::array<double, 2>> pointAlong(io::OutputDomain const& fault, double distance)
{
  const io::NodeGather gather(fault);
  const auto coordinates = gather(fault.coordinates, 1, fault.dimension);
  auto const distances = gather(faultAxis(fault).distances, 1, 1);
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

namespace
{
FaultPlaces onCurve(io::OutputDomain const& fault)
{
  FaultAxis axis = faultAxis(fault);
  const std::vector<double> zeros(axis.distances.size(), 0);
  return axis.is_level ? FaultPlaces{axis.distances, zeros} : FaultPlaces{zeros, axis.distances};
}

FaultPlaces onSurface(io::OutputDomain const& fault, Direction const& up)
{
  const FaultPlane plane = faultPlane(fault, up);
  FaultPlaces places;
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    places.along_strike.push_back(plane.alongStrike(&fault.coordinates[3 * i]));
    places.down_dip.push_back(plane.downDip(&fault.coordinates[3 * i]));
  }
  return places;
}
} // namespace

FaultPlaces faultPlaces(io::OutputDomain const& fault, Direction const& up)
{
  return fault.isCurve() ? onCurve(fault) : onSurface(fault, up);
}
} // namespace asperity::catalogue
