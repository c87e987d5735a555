#include "catalogue/receivers/ReceiversOnFault.hpp"

#include "base/Text.hpp"
#include "catalogue/receivers/PointLocation.hpp"
#include "catalogue/receivers/ReceiverPlaces.hpp"
#include "catalogue/receivers/Receivers.hpp"
#include "mesh/Crossings.hpp"
#include "mesh/Joints.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace asperity::catalogue
{
namespace
{
// As a share of the size of a cell: coordinates on an inclined fault are rounded.
constexpr double rounding_share = 1e-6;
constexpr double off_fault = 1e-3; // far enough to tell the sides apart

// (num_owned) of a domain: 1 at nodes whose vertex is in the set.
std::vector<double> nodesIn(io::OutputDomain const& domain, std::set<int> const& vertices)
{
  std::vector<double> result;
  for (const int vertex : domain.vertices) {
    result.push_back(vertices.count(vertex) > 0 ? 1 : 0);
  }
  return result;
}

// Of each located point: the number of its boundary among those that a fault is made of.
std::vector<double> boundariesAt(io::OutputDomain const& fault,
                                 std::vector<LocatedPoint> const& located)
{
  if (fault.boundaries.empty()) {
    return std::vector<double>(located.size(), 0.);
  }
  const std::vector<double> numbers(fault.element_boundaries.begin(),
                                    fault.element_boundaries.end());
  return Sampling(fault, located, io::Centring::elements)(numbers, 1);
}
} // namespace

std::optional<Warning> warnOfReceiversOnFault(ParameterList const& receivers,
                                              ReceiverDomains const& domains,
                                              std::vector<SplitVertex> const& splits)
{
  auto const& [volume, fault, ground] = domains;
  if (!ReceiverSettings::from(receivers).is_enabled) {
    return std::nullopt;
  }
  std::vector<std::string> names;
  std::vector<double> places;
  const auto add = [&](std::string const& name, std::vector<double> const& place) {
    names.push_back(name);
    places.insert(places.end(), place.begin(), place.end());
  };
  for (auto const& place : placesIn(receivers, off_fault_list)) {
    if (static_cast<int>(place.coordinates.size()) == volume.dimension) { // others are refused
      add(place.name, place.coordinates);
    }
  }
  auto const on_ground = placesIn(receivers, on_ground_list);
  auto const points = pointsOnGround(on_ground, ground);
  for (std::size_t i = 0; i < points.size(); ++i) {
    add(on_ground[i].name, points[i].coordinates);
  }
  if (names.empty()) {
    return std::nullopt;
  }
  std::set<int> cut; // the plus vertices, but for tips
  for (auto const& split : splits) {
    if (!split.is_tip) {
      cut.insert(split.plus);
    }
  }
  auto of_plus_side = cut; // at a crossing or a joint the other end of the facet decides
  for (auto const& [mean, plus, both] : mesh::crossingsOf(splits)) {
    for (const int vertex : {plus[0], plus[1], both}) {
      of_plus_side.erase(vertex);
    }
  }
  for (auto const& joint : mesh::jointsOf(splits)) {
    of_plus_side.erase(joint.plus);
    of_plus_side.erase(joint.minus);
  }
  const auto on_fault = locate(fault, places), in_body = locate(volume, places);
  const auto apart = Sampling(fault, on_fault)(nodesIn(fault, cut), 1);
  const auto plus = Sampling(volume, in_body)(nodesIn(volume, of_plus_side), 1);
  const auto boundaries = boundariesAt(fault, on_fault);
  std::string found;
  double cell = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto const& point = on_fault[i];
    if (point.distance > rounding_share * point.element_size || !(apart[i] > 0)) {
      continue;
    }
    cell = found.empty() ? point.element_size : std::min(cell, point.element_size);
    found += (found.empty() ? "'" : ", '") + names[i] + "' at " + formatPoint(point.coordinates) +
             " m records the " + (plus[i] > 0 ? "plus" : "minus") + " side";
    if (!fault.boundaries.empty()) {
      found += " of '" + fault.boundaries[std::lround(boundaries[i])] + "'";
    }
  }
  if (found.empty()) {
    return std::nullopt;
  }
  return Warning{"receivers on the fault",
                 "Output / Receivers: these lie on the fault, whose two sides move "
                 "apart: " +
                   found + ". Move each off the fault to the side that you want; " +
                   formatShort(off_fault * cell) + " m are enough."};
}
} // namespace asperity::catalogue
