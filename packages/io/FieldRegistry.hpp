#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace asperity::io
{
// Whether a field has values at the nodes of its domain, or is constant in each of its elements.
enum class Centring
{
  nodes,
  elements
};

// A field that outputs may write, known by its domain and its name.
struct OutputField
{
  using Values = std::function<void(std::vector<double>&)>;

  std::string name;        // snake_case, for example "slip_rate"
  std::string unit;        // for example "m/s"; "" if dimensionless
  std::string description; // one sentence
  std::string domain;      // "fault", "surface" or "volume"
  int components = 1;

  // Fills this rank's values: (num_owned, components), components fastest, in the order of the
  // domain's owned nodes, or of its owned elements. Resizes its argument. Called on every rank at
  // once.
  Values values;

  Centring centring = Centring::nodes;
  std::vector<std::string> component_names = {}; // (components) "xx", "xy", ...; may be empty

  // The same at a few places, (places, components): the places are among the owned nodes or
  // elements. Empty where that is not cheaper than all values. Called on every rank at once, once
  // before the first values are taken.
  std::function<Values(std::vector<std::size_t> const& places)> at = {};
};

// A number that describes an accepted step, the same on every rank.
struct OutputScalar
{
  std::string name; // snake_case, for example "fixed_point_iterations"
  std::string unit;
  std::string description;
  std::function<double()> value;
};

// The fields and scalars that a run offers to its outputs. The scenario adds them; outputs ask for
// them by name.
class FieldRegistry
{
public:
  // Adding a name a second time (on the same domain) is an internal error.
  void add(OutputField field);
  void add(OutputScalar scalar);

  // Throw InputError, which names the nearest known name, if there is no such field or scalar.
  OutputField const& field(std::string const& domain, std::string const& name) const;
  OutputScalar const& scalar(std::string const& name) const;

  // The fields of these names, in this order; `where` is the entry of the deck that has the names.
  // Throws InputError as field() does, and if a name occurs twice.
  std::vector<OutputField const*> fields(std::string const& domain,
                                         std::vector<std::string> const& names,
                                         std::string const& where) const;

  bool hasField(std::string const& domain, std::string const& name) const;

  // In the order in which they were added.
  std::vector<std::string> fieldNames(std::string const& domain) const;
  std::vector<std::string> scalarNames() const;

private:
  std::deque<OutputField> fields_; // a deque, because outputs keep references
  std::deque<OutputScalar> scalars_;
};
} // namespace asperity::io
