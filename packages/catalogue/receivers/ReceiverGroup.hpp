#pragma once

#include "base/Warning.hpp"
#include "catalogue/receivers/Ground.hpp"
#include "catalogue/receivers/PointLocation.hpp"
#include "catalogue/receivers/ReceiverPlaces.hpp"
#include "io/Output.hpp"
#include "io/series/SegmentedTable.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::catalogue
{
// Receivers on the fault, or in the body.
class ReceiverGroup
{
public:
  // Places of `On Ground` are moved to the ground first, which is null where the model has no free
  // surface. Throws InputError for a place farther from the domain than a hundredth of the nearest
  // element's size, with the height of the ground there, and for a name that no file can have.
  // Collective.
  ReceiverGroup(std::vector<NamedPlace> const& places, io::OutputDomain const& domain,
                Ground const* ground = nullptr);

  // Which receivers do not lie at the place of the deck, where they lie and how far from it, beyond
  // rounding, for the log.
  std::vector<std::string> notes() const;
  // A warning of those that the move to the ground took farther than the facet is long that has
  // them: the height in the deck is hardly the one of this ground.
  std::optional<Warning> warning() const;

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
  std::vector<double> wantedPoints(Ground const* ground);
  std::vector<double> pointOnDomain(std::size_t receiver) const; // (dimension) [m]
  bool hasHeight(std::size_t receiver) const; // whether the deck gives all coordinates

  io::OutputDomain const& domain_;
  std::vector<NamedPlace> places_;
  std::map<std::size_t, GroundPoint> on_ground_; // of the receivers on the ground
  std::map<std::size_t, double> projected_;      // [m] those moved to the domain, beyond rounding
  std::vector<double> coordinates_;              // (num_receivers, dimension) [m] on the domain
  std::vector<double> positions_;                // (num_receivers) [m] of a curve, otherwise empty
  std::unique_ptr<Sampling> sampling_, element_sampling_; // nodal values, those of elements
  std::vector<io::OutputField const*> chosen_;
  // How the values at the receivers' places are found, of each field that was sampled.
  mutable std::map<io::OutputField const*, io::OutputField::Values> values_at_places_;
};
} // namespace asperity::catalogue
