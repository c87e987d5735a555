#pragma once

#include "io/Output.hpp"
#include "io/catalogue/receivers/PointLocation.hpp"
#include "io/platforms/PlatformStations.hpp"
#include "io/series/SegmentedTable.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace asperity::io::detail
{
// A named place, as the deck has it.
struct NamedPlace
{
  std::string name;
  std::vector<double> coordinates; // (dimension) [m]
};

// Receivers on the fault, or in the body.
class ReceiverGroup
{
public:
  // `path` is that of the list in the deck, for messages: a place further from the location than
  // a hundredth of its element there is an InputError, as is a name that no file can have.
  // Collective.
  ReceiverGroup(std::string const& path, std::vector<NamedPlace> const& places,
                Location const& location);

  // The fields that are written to receivers.h5, as columns `<group>/fields/<name>`; `where` is
  // the entry of the deck that names them.
  void chooseFields(std::vector<std::string> const& names, FieldRegistry const& registry,
                    std::string const& where);
  std::vector<SegmentedTable::Column> columns(std::string const& group) const;

  // Text files with the columns of a platform; `prefix` begins their names.
  void writeText(OutputContext const& context, std::string const& prefix,
                 PlatformColumns const& columns);
  PlatformStations* text() { return text_.get(); }
  PlatformStations const* text() const { return text_.get(); }

  // Values of all fields that anybody asked for, (num_receivers, components) by name. Collective.
  std::map<std::string, std::vector<double>> sample() const;
  std::vector<std::string> const& chosenFields() const { return chosen_; }

  // Names and places. On rank 0.
  void describe(h5::File& file, std::string const& group) const;

  // What a restart must find unchanged.
  std::string signature() const;

private:
  void use(Field const& field);

  Location const& location_;
  std::vector<NamedPlace> places_;
  std::vector<double> coordinates_; // (num_receivers, dimension) [m] on the location
  std::vector<double> positions_;   // (num_receivers) [m] of a curve, otherwise empty
  std::unique_ptr<Sampling> sampling_;
  std::vector<std::string> chosen_;
  std::map<std::string, Field const*> fields_;
  std::unique_ptr<PlatformStations> text_;
};
} // namespace asperity::io::detail
