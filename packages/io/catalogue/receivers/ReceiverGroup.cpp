#include "io/catalogue/receivers/ReceiverGroup.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "io/parallel/Gather.hpp"
#include "io/series/SeriesLayout.hpp"

#include <algorithm>
#include <limits>

namespace asperity::io::detail
{
namespace
{
// Of an element's size: how far beside the location a receiver may lie. Coordinates on an inclined
// fault or surface are rounded.
constexpr double reach = 0.01;

std::string pointText(double const* point, int dimension)
{
  std::string text;
  for (int d = 0; d < dimension; ++d) {
    text += (d > 0 ? ", " : "(") + formatNumber(point[d]);
  }
  return text + ")";
}

// "from (0, -40000) to (0, 0) m": the corners of the box around the location.
std::string extentText(Location const& location)
{
  std::vector<double> least, largest;
  for (int d = 0; d < location.dimension; ++d) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < location.numOwned(); ++i) {
      low = std::min(low, location.coordinates[i * location.dimension + d]);
      high = std::max(high, location.coordinates[i * location.dimension + d]);
    }
    least.push_back(minOverRanks(low, *location.comm));
    largest.push_back(maxOverRanks(high, *location.comm));
  }
  return "from " + pointText(least.data(), location.dimension) + " to " +
         pointText(largest.data(), location.dimension) + " m";
}

// Files are named after receivers.
void requireFileName(std::string const& path, std::string const& name)
{
  ASPERITY_REQUIRE(!name.empty() && name.find('/') == std::string::npos,
                   path << ": a receiver cannot be called '" << name
                        << "', because files are named after it. Choose a name without '/'.");
}

void requireNear(std::string const& path, NamedPlace const& place, LocatedPoint const& located,
                 Location const& location)
{
  if (located.distance <= reach * located.element_size) {
    return;
  }
  const bool is_volume = location.nodes_per_element == location.dimension + 1;
  const std::string where = is_volume ? "mesh" : location.name;
  throw InputError(
    path + " / " + place.name + " = " + pointText(place.coordinates.data(), location.dimension) +
    " is " + formatShort(located.distance) + " m outside of the " + where + ", which extends " +
    extentText(location) + "; its nearest element has " + formatShort(located.element_size) +
    " m. A receiver may be " + formatShort(reach * located.element_size) + " m beside it.");
}
} // namespace

ReceiverGroup::ReceiverGroup(std::string const& path, std::vector<NamedPlace> const& places,
                             Location const& location)
    : location_(location)
    , places_(places)
{
  std::vector<double> wanted;
  for (auto const& place : places) {
    requireFileName(path, place.name);
    ASPERITY_REQUIRE(static_cast<int>(place.coordinates.size()) == location.dimension,
                     path << " / " << place.name << " has " << place.coordinates.size()
                          << " coordinates; a position in this mesh has " << location.dimension
                          << ".");
    wanted.insert(wanted.end(), place.coordinates.begin(), place.coordinates.end());
  }
  const auto located = locate(location, wanted);
  for (std::size_t i = 0; i < located.size(); ++i) {
    requireNear(path, places[i], located[i], location);
    coordinates_.insert(coordinates_.end(), located[i].coordinates.begin(),
                        located[i].coordinates.end());
  }
  sampling_ = std::make_unique<Sampling>(location, located);
  if (location.isCurve()) {
    positions_ = (*sampling_)(location.positions, 1);
  }
}

void ReceiverGroup::use(Field const& field) { fields_[field.name] = &field; }

void ReceiverGroup::chooseFields(std::vector<std::string> const& names,
                                 FieldRegistry const& registry, std::string const& where)
{
  chosen_ = names;
  for (Field const* field : registry.fields(location_.name, names, where)) {
    use(*field);
  }
}

std::vector<SegmentedTable::Column> ReceiverGroup::columns(std::string const& group) const
{
  std::vector<SegmentedTable::Column> columns;
  for (auto const& name : chosen_) {
    Field const& field = *fields_.at(name);
    columns.push_back({group + "/fields/" + name, field.unit, field.description, h5::Type::float64,
                       rowShape(places_.size(), field.components)});
  }
  return columns;
}

void ReceiverGroup::writeText(OutputContext const& context, std::string const& prefix,
                              PlatformColumns const& columns)
{
  const bool is_volume = location_.nodes_per_element == location_.dimension + 1;
  std::vector<PlatformStations::Station> stations;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    stations.push_back({prefix + places_[i].name,
                        std::string(is_volume ? "off fault, " : "on fault, ") +
                          pointText(&coordinates_[i * location_.dimension], location_.dimension) +
                          " m"});
  }
  for (auto const& name : fieldsOf(columns)) {
    use(context.fields.field(location_.name, name));
  }
  text_ = std::make_unique<PlatformStations>(context.text, context.directory, stations, columns,
                                             context.comm);
}

std::map<std::string, std::vector<double>> ReceiverGroup::sample() const
{
  std::map<std::string, std::vector<double>> sampled;
  std::vector<double> nodal;
  for (auto const& [name, field] : fields_) {
    field->values(nodal);
    sampled[name] = (*sampling_)(nodal, field->components);
  }
  return sampled;
}

void ReceiverGroup::describe(h5::File& file, std::string const& group) const
{
  std::vector<std::string> names;
  for (auto const& place : places_) {
    names.push_back(place.name);
  }
  detail::describe(file.createTexts(group + "/names", names), "-", "Names of the receivers.");
  const hsize_t dimension = location_.dimension;
  writeDataset(file, group + "/coordinates", coordinates_, {places_.size(), dimension}, "m",
               "Coordinates of the receivers.");
  if (!positions_.empty()) {
    writeDataset(file, group + "/positions", positions_, {places_.size()}, "m",
                 "Distance along the boundary from its first end.");
  }
}

std::string ReceiverGroup::signature() const
{
  std::string text;
  for (auto const& place : places_) {
    text += place.name + ' ' + pointText(place.coordinates.data(), location_.dimension) + '\n';
  }
  for (auto const& name : chosen_) {
    text += name + '\n';
  }
  return text_ ? text + text_->signature() : text;
}
} // namespace asperity::io::detail
