#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace asperity::io
{
// A field that outputs may write, known by its location and its name.
struct Field
{
  std::string name;        // snake_case, for example "slip_rate"
  std::string unit;        // for example "m/s"; "" if dimensionless
  std::string description; // one sentence
  std::string location;    // "fault", "surface" or "volume"
  int components = 1;

  // Fills this rank's values: (num_owned, components), components fastest, in the order of the
  // location's owned nodes. Resizes its argument. Called on every rank at once.
  std::function<void(std::vector<double>&)> values;
};

// A number that describes an accepted step, the same on every rank.
struct Scalar
{
  std::string name; // snake_case, for example "fixed_point_iterations"
  std::string unit;
  std::string description;
  std::function<double()> value;
};

// What a run has to offer to its outputs. The scenario fills it; outputs ask by name.
class FieldRegistry
{
public:
  // Adding a name a second time (on the same location) is an internal error.
  void add(Field field);
  void add(Scalar scalar);

  // InputError that names the nearest known one if there is no such field or scalar.
  Field const& field(std::string const& location, std::string const& name) const;
  Scalar const& scalar(std::string const& name) const;

  // Those of the names, in their order; `where` is the entry of the deck that has the names.
  // InputError as for field, and if a name stands there twice.
  std::vector<Field const*> fields(std::string const& location,
                                   std::vector<std::string> const& names,
                                   std::string const& where) const;

  bool hasField(std::string const& location, std::string const& name) const;

  // In the order in which they were added.
  std::vector<std::string> fieldNames(std::string const& location) const;
  std::vector<std::string> scalarNames() const;

private:
  std::deque<Field> fields_; // a deque, because outputs keep references
  std::deque<Scalar> scalars_;
};
} // namespace asperity::io
