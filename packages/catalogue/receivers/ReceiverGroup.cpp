#include "catalogue/receivers/ReceiverGroup.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "catalogue/fault_geometry/FaultAxis.hpp"
#include "io/series/SeriesLayout.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace asperity::catalogue
{
namespace
{
// How far from the domain a receiver may lie, as a share of the element's size: coordinates on an
// inclined fault or surface are rounded.
constexpr double reach = 0.01;
constexpr double least_move = 1e-6; // as above; what is less is no move

std::string pointText(std::vector<double> const& point) { return formatPoint(point, formatNumber); }

// "from (0, -40000) to (0, 0) m": the corners of the box around the domain.
std::string extentText(io::OutputDomain const& domain)
{
  std::vector<double> least, largest;
  for (int d = 0; d < domain.dimension; ++d) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < domain.numOwned(); ++i) {
      low = std::min(low, domain.coordinates[i * domain.dimension + d]);
      high = std::max(high, domain.coordinates[i * domain.dimension + d]);
    }
    least.push_back(minOverRanks(low, *domain.comm));
    largest.push_back(maxOverRanks(high, *domain.comm));
  }
  return "from " + pointText(least) + " to " + pointText(largest) + " m";
}

// "mesh" or "fault", for messages.
std::string domainText(io::OutputDomain const& domain)
{
  return domain.nodes_per_element == domain.dimension + 1 ? "mesh" : domain.name;
}

// Files are named after receivers.
void requireFileName(NamedPlace const& place)
{
  ASPERITY_REQUIRE(!place.name.empty() && place.name.find('/') == std::string::npos,
                   joinPath(receivers_path, place.list)
                     << ": a receiver cannot be called '" << place.name
                     << "', because files are named after it. Choose a name without '/'.");
}

// "(0, 0, 312.5)", with digits enough for decimetres in coordinates of a map.
std::string roundedText(std::vector<double> const& point)
{
  return formatPoint(point, [](double x) { return formatted("%.8g", x); });
}

// The same, where coordinates that rounding alone keeps from zero are zero.
std::string placeText(GroundPoint const& point)
{
  auto coordinates = point.coordinates;
  for (double& x : coordinates) {
    x = std::abs(x) > least_move * point.element_size ? x : 0;
  }
  return roundedText(coordinates);
}

// "87.5 m below it"
std::string riseText(GroundPoint const& point, std::string const& what)
{
  return formatShort(std::abs(point.rise)) + " m " + (point.rise < 0 ? "below " : "above ") + what;
}

// "The free surface there is at (0, 0, 312.5) m, 87.5 m below it: ..."; empty without ground above
// or below the place. Collective.
std::string groundText(std::vector<double> const& point, Ground const* ground)
{
  auto const found = ground ? (*ground)(point).front() : std::nullopt;
  if (!found) {
    return "";
  }
  return " The free surface there is at " + placeText(*found) + " m, " + riseText(*found, "it") +
         "; the list " + on_ground_list + " moves receivers there.";
}

// point: of the place, with all coordinates. Collective.
void requireNear(NamedPlace const& place, std::vector<double> const& point,
                 LocatedPoint const& located, io::OutputDomain const& domain, Ground const* ground)
{
  if (located.distance <= reach * located.element_size) {
    return;
  }
  throw InputError(place.path() + " = " + pointText(place.coordinates) + " is " +
                   formatShort(located.distance) + " m outside of the " + domainText(domain) +
                   ", whose coordinates go " + extentText(domain) +
                   "; its nearest element has a size of " + formatShort(located.element_size) +
                   " m. A receiver may be at most " + formatShort(reach * located.element_size) +
                   " m outside." + groundText(point, ground));
}

// The coordinates of a place in the deck, which on a curve may be given as a distance along it.
std::vector<double> pointOf(NamedPlace const& place, io::OutputDomain const& domain)
{
  auto const& given = place.coordinates;
  if (given.size() == 1 && domain.isCurve()) {
    auto const point = pointAlong(domain, given.front());
    ASPERITY_REQUIRE(point, place.path() << ": the " << domain.name << " is not as long as "
                                         << formatShort(given.front()) << " m; its coordinates go "
                                         << extentText(domain) << ".");
    return {point->begin(), point->end()};
  }
  ASPERITY_REQUIRE(static_cast<int>(given.size()) == domain.dimension,
                   place.path() << " has " << given.size()
                                << " coordinates; a position in this mesh has " << domain.dimension
                                << (domain.isCurve() ? ", or one, the distance along the " +
                                                         domain.name + " from its upper end."
                                                     : "."));
  return given;
}

// "'a', 'b' and 17 more": at most ten of the texts.
std::string firstOf(std::vector<std::string> const& texts)
{
  constexpr std::size_t most = 10;
  std::string result;
  for (std::size_t i = 0; i < std::min(most, texts.size()); ++i) {
    result += (i == 0 ? "" : ", ") + texts[i];
  }
  return texts.size() <= most ? result
                              : result + " and " + std::to_string(texts.size() - most) + " more";
}
} // namespace

ReceiverGroup::ReceiverGroup(std::vector<NamedPlace> const& places, io::OutputDomain const& domain,
                             Ground const* ground)
    : domain_(domain)
    , places_(places)
{
  const auto wanted = wantedPoints(ground);
  const auto located = locate(domain, wanted);
  const auto dimension = static_cast<std::ptrdiff_t>(domain.dimension);
  for (std::size_t i = 0; i < located.size(); ++i) {
    auto const first = wanted.begin() + static_cast<std::ptrdiff_t>(i) * dimension;
    requireNear(places[i], {first, first + dimension}, located[i], domain, ground);
    if (located[i].distance > least_move * located[i].element_size) {
      projected_[i] = located[i].distance;
    }
    coordinates_.insert(coordinates_.end(), located[i].coordinates.begin(),
                        located[i].coordinates.end());
  }
  sampling_ = std::make_unique<Sampling>(domain, located);
  element_sampling_ = std::make_unique<Sampling>(domain, located, io::Centring::elements);
  if (domain.isCurve()) {
    positions_ = (*sampling_)(domain.positions, 1);
  }
}

// (num_receivers, dimension) [m], those on the ground moved there. Collective.
std::vector<double> ReceiverGroup::wantedPoints(Ground const* ground)
{
  std::vector<NamedPlace> moved;
  std::copy_if(places_.begin(), places_.end(), std::back_inserter(moved),
               [](auto const& place) { return place.isOnGround(); });
  auto const on_ground = pointsOnGround(moved, ground);
  std::vector<double> wanted;
  auto next = on_ground.begin();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    requireFileName(places_[i]);
    auto point = std::vector<double>();
    if (places_[i].isOnGround()) {
      point = next->coordinates;
      on_ground_[i] = *next++;
    } else {
      point = pointOf(places_[i], domain_);
    }
    wanted.insert(wanted.end(), point.begin(), point.end());
  }
  return wanted;
}

std::vector<double> ReceiverGroup::pointOnDomain(std::size_t receiver) const
{
  auto const first =
    coordinates_.begin() + static_cast<std::ptrdiff_t>(receiver) * domain_.dimension;
  return {first, first + domain_.dimension};
}

bool ReceiverGroup::hasHeight(std::size_t receiver) const
{
  return places_[receiver].coordinates.size() == static_cast<std::size_t>(domain_.dimension);
}

std::vector<std::string> ReceiverGroup::notes() const
{
  std::vector<std::string> on_ground, projected, notes;
  for (auto const& [i, point] : on_ground_) {
    const bool is_moved = hasHeight(i) && std::abs(point.rise) > least_move * point.element_size;
    on_ground.push_back('\'' + places_[i].name + "' at " + placeText(point) + " m" +
                        (is_moved ? ", " + riseText(point, "the given place") : ""));
  }
  for (auto const& [i, distance] : projected_) {
    projected.push_back('\'' + places_[i].name + "' by " + formatShort(distance) + " m to " +
                        roundedText(pointOnDomain(i)) + " m");
  }
  if (!on_ground.empty()) {
    notes.push_back("Receivers on the ground: " + firstOf(on_ground) + '.');
  }
  if (!projected.empty()) {
    notes.push_back("Receivers that lie outside of the " + domainText(domain_) +
                    " are moved to it: " + firstOf(projected) + '.');
  }
  return notes;
}

std::optional<Warning> ReceiverGroup::warning() const
{
  std::vector<std::string> far;
  for (auto const& [i, point] : on_ground_) {
    if (hasHeight(i) && std::abs(point.rise) > point.element_size) {
      far.push_back('\'' + places_[i].name + "' by " + formatShort(std::abs(point.rise)) +
                    " m, where the facets of the ground are " + formatShort(point.element_size) +
                    " m long");
    }
  }
  if (far.empty()) {
    return std::nullopt;
  }
  return Warning{"receivers far from the ground",
                 "Output / Receivers / On Ground: these are moved to the ground over more than the "
                 "size of a cell: " +
                   firstOf(far) +
                   ". Check unit, sign and datum of their heights and of the ground, or leave the "
                   "heights out."};
}

void ReceiverGroup::chooseFields(std::vector<std::string> const& names,
                                 io::FieldRegistry const& registry, std::string const& where)
{
  chosen_ = registry.fields(domain_.name, names, where);
}

std::vector<io::SegmentedTable::Column> ReceiverGroup::columns(std::string const& group) const
{
  std::vector<io::SegmentedTable::Column> columns;
  for (auto const* field : chosen_) {
    columns.push_back({group + "/fields/" + field->name, field->unit, field->description,
                       h5::Type::float64, io::rowShape(places_.size(), field->components),
                       io::SegmentedTable::Column::Support::run, io::componentsText(*field)});
  }
  return columns;
}

std::vector<double> ReceiverGroup::sample(io::OutputField const& field) const
{
  auto const& sampling = field.centring == io::Centring::nodes ? *sampling_ : *element_sampling_;
  auto found = values_at_places_.find(&field);
  if (found == values_at_places_.end()) {
    const auto at_places = field.at ? field.at(sampling.places()) : io::OutputField::Values();
    found = values_at_places_.emplace(&field, at_places).first;
  }
  std::vector<double> values;
  if (found->second) {
    found->second(values);
    return sampling.fromPlaces(values, field.components);
  }
  field.values(values);
  return sampling(values, field.components);
}

void ReceiverGroup::describe(h5::File& file, std::string const& group) const
{
  std::vector<std::string> names;
  for (auto const& place : places_) {
    names.push_back(place.name);
  }
  io::describe(file.createTexts(group + "/names", names), "-", "Names of the receivers.");
  const hsize_t dimension = domain_.dimension;
  io::writeDataset(file, group + "/coordinates", coordinates_, {places_.size(), dimension}, "m",
                   "Coordinates of the receivers.");
  if (!positions_.empty()) {
    io::writeDataset(file, group + "/positions", positions_, {places_.size()}, "m",
                     "Distance along the " + domain_.name + " from " + io::startText(domain_) +
                       '.');
  }
}

std::string ReceiverGroup::signature() const
{
  std::string text;
  for (auto const& place : places_) {
    text += place.name + ' ' + pointText(place.coordinates) +
            (place.isOnGround() ? " on the ground\n" : "\n");
  }
  for (auto const* field : chosen_) {
    text += field->name + '\n';
  }
  return text;
}
} // namespace asperity::catalogue
