#include "catalogue/FaultFacts.hpp"

#include "catalogue/fault_geometry/FaultAxis.hpp"
#include "catalogue/receivers/PointLocation.hpp"

namespace asperity::catalogue
{
namespace
{
void addAxis(io::OutputDomain const& fault, io::Facts& facts)
{
  const auto axis = faultAxis(fault);
  const bool is_backward = !axis.is_level && axis.tangent_rises == fault.is_foot_wall;
  facts["level"] = {axis.is_level ? 1. : 0.};
  facts["thrust_sign"] = {is_backward ? -1. : 1.};
}

void addPlane(FaultPlane const& plane, io::Facts& facts)
{
  for (auto const& [name, direction] : {std::pair("strike", plane.strike),
                                        {"dip", plane.dip},
                                        {"down", plane.down},
                                        {"inward", plane.inward}}) {
    facts[name] = {direction.begin(), direction.end()};
  }
  facts["top"] = {plane.top};
}
} // namespace

io::Facts faultFacts(io::OutputDomain const& fault, Direction const& up)
{
  io::Facts facts;
  facts["element_size"] = {shortestElement(fault)};
  if (fault.isCurve()) {
    addAxis(fault, facts);
  } else if (auto const plane = meanPlane(fault, up)) {
    addPlane(*plane, facts);
  }
  return facts;
}
} // namespace asperity::catalogue
