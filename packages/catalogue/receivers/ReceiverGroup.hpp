#pragma once

#include "catalogue/receivers/PointLocation.hpp"
#include "io/Output.hpp"
#include "io/series/SegmentedTable.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace asperity::catalogue
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
  // `path` is that of the list in the deck, for messages. Throws InputError for a place farther
  // from the domain than a hundredth of the nearest element's size, and for a name that no file can
  // have.
  // Collective.
  ReceiverGroup(std::string const& path, std::vector<NamedPlace> const& places,
                io::OutputDomain const& domain);

  // The fields that are written to receivers.h5, as columns `<group>/fields/<name>`; `where` is
  // the entry of the deck that names them.
  void chooseFields(std::vector<std::string> const& names, io::FieldRegistry const& registry,
                    std::string const& where);
  std::vector<io::SegmentedTable::Column> columns(std::string const& group) const;

  // Values of a field of the domain, (num_receivers, components), on every rank. Collective.
  std::vector<double> sample(io::OutputField const& field) const;
  std::vector<io::OutputField const*> const& chosenFields() const { return chosen_; }

  // Names and places. On rank 0.
  void describe(h5::File& file, std::string const& group) const;

  // What a restart must find unchanged.
  std::string signature() const;

private:
  io::OutputDomain const& domain_;
  std::vector<NamedPlace> places_;
  std::vector<double> coordinates_; // (num_receivers, dimension) [m] on the domain
  std::vector<double> positions_;   // (num_receivers) [m] of a curve, otherwise empty
  std::unique_ptr<Sampling> sampling_, element_sampling_; // nodal values, those of elements
  std::vector<io::OutputField const*> chosen_;
  // How the values at the receivers' places are found, of each field that was sampled.
  mutable std::map<io::OutputField const*, io::OutputField::Values> values_at_places_;
};
} // namespace asperity::catalogue
