#include "catalogue/receivers/ReceiverPlaces.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <Teuchos_Array.hpp>

#include <cstddef>
#include <set>

namespace asperity::catalogue
{
namespace
{
// The place with all its coordinates.
std::vector<double> completed(NamedPlace const& place, Ground const& ground)
{
  auto coordinates = place.coordinates;
  const auto dimension = static_cast<std::size_t>(ground.dimension());
  const auto axis = ground.verticalAxis();
  if (axis && coordinates.size() + 1 == dimension) {
    coordinates.insert(coordinates.begin() + *axis, 0.);
  }
  ASPERITY_REQUIRE(coordinates.size() == dimension,
                   place.path() << " has " << place.coordinates.size()
                                << " coordinates; a position in this mesh has " << dimension
                                << (axis ? ", or " + std::to_string(dimension - 1) + " without " +
                                             "xyz"[*axis] + ", which is up."
                                         : "."));
  return coordinates;
}
} // namespace

std::string NamedPlace::path() const { return joinPath(joinPath(receivers_path, list), name); }

std::vector<NamedPlace> placesIn(ParameterList const& receivers, std::string const& list)
{
  std::vector<NamedPlace> places;
  auto const& entries = receivers.sublist(list);
  for (auto const& entry : entries) {
    places.push_back(
      {list, entry.first, entries.get<Teuchos::Array<double>>(entry.first).toVector()});
  }
  return places;
}

std::vector<NamedPlace> placesInBody(ParameterList const& receivers)
{
  auto places = placesIn(receivers, off_fault_list);
  std::set<std::string> names;
  for (auto const& place : places) {
    names.insert(place.name);
  }
  for (auto& place : placesIn(receivers, on_ground_list)) {
    ASPERITY_REQUIRE(names.count(place.name) == 0,
                     place.path() << ": a receiver of this name is in " << off_fault_list
                                  << ", too. Give each a name of its own.");
    places.push_back(std::move(place));
  }
  return places;
}

std::vector<GroundPoint> pointsOnGround(std::vector<NamedPlace> const& places, Ground const* ground)
{
  if (places.empty()) {
    return {};
  }
  ASPERITY_REQUIRE(ground != nullptr,
                   places.front().path()
                     << ": the model has no ground. Give the boundary that is the ground the Type "
                        "Free Surface, or name the place in "
                     << off_fault_list << ".");
  std::vector<double> points;
  for (auto const& place : places) {
    auto const point = completed(place, *ground);
    points.insert(points.end(), point.begin(), point.end());
  }
  std::vector<GroundPoint> result;
  auto const found = (*ground)(points);
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASPERITY_REQUIRE(found[i], places[i].path()
                                 << " = " << formatPoint(places[i].coordinates, formatNumber)
                                 << " has no ground above or below it: it lies beside the free "
                                    "surface, the first one of the deck. Check its coordinates.");
    result.push_back(*found[i]);
  }
  return result;
}
} // namespace asperity::catalogue
