#include "catalogue/fault_geometry/FaultPlaces.hpp"

#include "base/parallel/Reductions.hpp"
#include "io/parallel/NodeGather.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <cmath>

namespace asperity::catalogue
{
FaultAxis faultAxis(io::OutputDomain const& fault)
{
  const io::NodeGather gather(fault);
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

std::optional<std::array<double, 2>> pointAlong(io::OutputDomain const& fault, double distance)
{
  const io::NodeGather gather(fault);
  const auto coordinates = gather(fault.coordinates, 1, fault.dimension);
  auto const distances = faultAxis(fault).distances;
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
  FaultPlaces mine;
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    mine.along_strike.push_back(plane.alongStrike(&fault.coordinates[3 * i]));
    mine.down_dip.push_back(plane.downDip(&fault.coordinates[3 * i]));
  }
  const io::NodeGather gather(fault);
  return {gather(mine.along_strike, 1, 1), gather(mine.down_dip, 1, 1)};
}
} // namespace

FaultPlaces faultPlaces(io::OutputDomain const& fault, Direction const& up)
{
  return fault.isCurve() ? onCurve(fault) : onSurface(fault, up);
}
} // namespace asperity::catalogue
