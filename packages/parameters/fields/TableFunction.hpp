#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace asperity
{
// The rows of a table, which gives a function of one variable.
struct TableRows
{
  std::vector<double> arguments, values; // (num rows)
  std::string value_unit = {}; // as it is named, of what the values were; empty: not named
  // (num rows) where each row is, for messages: "line 5 of 'crust.csv'"; empty: "row 5"
  std::vector<std::string> places = {};

  std::string place(std::size_t row) const;
};

// How a table becomes a function. Its arguments are those from the first to the last row, both
// included.
struct TableRule
{
  enum class Interpolation
  {
    linear,  // between rows; a table that has an argument twice jumps there
    nearest, // the value of the nearest row; of two that are as near, the one behind
    step     // the value of the last row whose argument is not greater: a row begins a layer
  };
  enum class Outside
  {
    error,
    nearest, // the value of the first or last row
    value    // value_outside
  };
  Interpolation interpolation = Interpolation::linear;
  Outside outside = Outside::error;
  double value_outside = 0;
};

// A function of one variable, in SI units, that formulas of a deck call by name. Where it jumps, at
// the argument of a row or half way between two, it has the value of the greater arguments. It has
// no state: any number of threads may call it.
class TableFunction
{
public:
  // path: of the table in the deck, with which each message begins. InputError unless there are two
  // rows or more of finite numbers, whose arguments ascend; a linear function may have the same
  // argument in two rows.
  TableFunction(TableRows rows, TableRule const& rule, std::string path);

  // NaN for NaN. InputError outside of the table, if the rule says so.
  double operator()(double argument) const;

  std::string const& path() const { return path_; }
  // The unit that the file or the deck names for the values; empty if none.
  std::string const& valueUnit() const { return value_unit_; }

private:
  double inside(double argument) const;

  std::vector<double> arguments_, values_;
  TableRule rule_;
  std::string path_, value_unit_;
};

// The functions of a deck by their names.
struct TableFunctions
{
  std::map<std::string, TableFunction> of_name;
};
} // namespace asperity
