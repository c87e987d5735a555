#include "catalogue/receivers/ReceiverGroup.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "catalogue/fault_geometry/FaultAxis.hpp"
#include "io/series/SeriesLayout.hpp"

#include <algorithm>
#include <limits>

namespace asperity::catalogue
{
namespace
{
// How far from the domain a receiver may lie, as a share of the element's size: coordinates on an
// inclined fault or surface are rounded.
constexpr double reach = 0.01;

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

// Files are named after receivers.
void requireFileName(std::string const& path, std::string const& name)
{
  ASPERITY_REQUIRE(!name.empty() && name.find('/') == std::string::npos,
                   path << ": a receiver cannot be called '" << name
                        << "', because files are named after it. Choose a name without '/'.");
}

void requireNear(std::string const& path, NamedPlace const& place, LocatedPoint const& located,
                 io::OutputDomain const& domain)
{
  if (located.distance <= reach * located.element_size) {
    return;
  }
  const bool is_volume = domain.nodes_per_element == domain.dimension + 1;
  const std::string where = is_volume ? "mesh" : domain.name;
  throw InputError(path + " / " + place.name + " = " + pointText(place.coordinates) + " is " +
                   formatShort(located.distance) + " m outside of the " + where +
                   ", whose coordinates go " + extentText(domain) +
                   "; its nearest element has a size of " + formatShort(located.element_size) +
                   " m. A receiver may be at most " + formatShort(reach * located.element_size) +
                   " m outside.");
}
} // namespace

namespace
{
// The coordinates of a place in the deck, which on a curve may be given as a distance along it.
std::vector<double> pointOf(std::string const& path, NamedPlace const& place,
                            io::OutputDomain const& domain)
{
  auto const& given = place.coordinates;
  if (given.size() == 1 && domain.isCurve()) {
    auto const point = pointAlong(domain, given.front());
    ASPERITY_REQUIRE(point, path << " / " << place.name << ": the " << domain.name
                                 << " is not as long as " << formatShort(given.front())
                                 << " m; its coordinates go " << extentText(domain) << ".");
    return {point->begin(), point->end()};
  }
  ASPERITY_REQUIRE(static_cast<int>(given.size()) == domain.dimension,
                   path << " / " << place.name << " has " << given.size()
                        << " coordinates; a position in this mesh has " << domain.dimension
                        << (domain.isCurve() ? ", or one, the distance along the " + domain.name +
                                                 " from its upper end."
                                             : "."));
  return given;
}
} // namespace

ReceiverGroup::ReceiverGroup(std::string const& path, std::vector<NamedPlace> const& places,
                             io::OutputDomain const& domain)
    : domain_(domain)
    , places_(places)
{
  std::vector<double> wanted;
  for (auto const& place : places) {
    requireFileName(path, place.name);
    auto const point = pointOf(path, place, domain);
    wanted.insert(wanted.end(), point.begin(), point.end());
  }
  const auto located = locate(domain, wanted);
  for (std::size_t i = 0; i < located.size(); ++i) {
    requireNear(path, places[i], located[i], domain);
    coordinates_.insert(coordinates_.end(), located[i].coordinates.begin(),
                        located[i].coordinates.end());
  }
  sampling_ = std::make_unique<Sampling>(domain, located);
  element_sampling_ = std::make_unique<Sampling>(domain, located, io::Centring::elements);
  if (domain.isCurve()) {
    positions_ = (*sampling_)(domain.positions, 1);
  }
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
    text += place.name + ' ' + pointText(place.coordinates) + '\n';
  }
  for (auto const* field : chosen_) {
    text += field->name + '\n';
  }
  return text;
}
} // namespace asperity::catalogue
