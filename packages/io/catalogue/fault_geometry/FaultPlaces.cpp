#include "io/catalogue/fault_geometry/FaultPlaces.hpp"

#include "io/catalogue/fault_geometry/FaultAxis.hpp"
#include "io/parallel/NodeGather.hpp"

namespace asperity::io::detail
{
namespace
{
FaultPlaces onCurve(Location const& fault)
{
  FaultAxis axis = faultAxis(fault);
  const std::vector<double> zeros(axis.distances.size(), 0);
  return axis.is_level ? FaultPlaces{axis.distances, zeros} : FaultPlaces{zeros, axis.distances};
}

FaultPlaces onSurface(Location const& fault, Direction const& up)
{
  const FaultPlane plane = faultPlane(fault, up);
  FaultPlaces mine;
  for (std::size_t i = 0; i < fault.numOwned(); ++i) {
    mine.along_strike.push_back(plane.alongStrike(&fault.coordinates[3 * i]));
    mine.down_dip.push_back(plane.downDip(&fault.coordinates[3 * i]));
  }
  const NodeGather gather(fault);
  return {gather(mine.along_strike, 1, 1), gather(mine.down_dip, 1, 1)};
}
} // namespace

FaultPlaces faultPlaces(Location const& fault, Direction const& up)
{
  return fault.isCurve() ? onCurve(fault) : onSurface(fault, up);
}
} // namespace asperity::io::detail
