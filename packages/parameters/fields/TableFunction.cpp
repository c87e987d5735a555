#include "parameters/fields/TableFunction.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity
{
namespace
{
using Interpolation = TableRule::Interpolation;
using Outside = TableRule::Outside;

void requireNumbers(TableRows const& rows, std::string const& path)
{
  for (std::size_t row = 0; row < rows.values.size(); ++row) {
    for (const double number : {rows.arguments[row], rows.values[row]}) {
      ASPERITY_REQUIRE(std::isfinite(number), path << ", " << rows.place(row) << ": "
                                                   << formatNumber(number)
                                                   << " is no finite number.");
    }
  }
}

void requireOrder(TableRows const& rows, Interpolation interpolation, std::string const& path)
{
  auto const& x = rows.arguments;
  for (std::size_t row = 1; row < x.size(); ++row) {
    ASPERITY_REQUIRE(x[row] >= x[row - 1],
                     path << ", " << rows.place(row) << ": the argument " << formatNumber(x[row])
                          << " is less than " << formatNumber(x[row - 1]) << " of the row before. "
                          << "Sort the rows by their arguments, or name the right column.");
    if (x[row] > x[row - 1]) {
      continue;
    }
    const bool may_jump = interpolation == Interpolation::linear;
    const bool is_third = row > 1 && x[row - 2] == x[row];
    ASPERITY_REQUIRE(may_jump && !is_third,
                     path << ", " << rows.place(row) << ": the argument " << formatNumber(x[row])
                          << " is that of the row before, too. "
                          << (may_jump ? "Two rows at most may share an argument: the values "
                                         "before and behind a jump."
                                       : "Only Interpolation = Linear may have two rows at an "
                                         "argument."));
  }
}
} // namespace

std::string TableRows::place(std::size_t row) const
{
  return places.empty() ? "row " + std::to_string(row + 1) : places[row];
}

TableFunction::TableFunction(TableRows rows, TableRule const& rule, std::string path)
    : rule_(rule)
    , path_(std::move(path))
{
  ASPERITY_REQUIRE(rows.arguments.size() == rows.values.size(),
                   path_ << " has " << rows.arguments.size() << " arguments, but "
                         << rows.values.size() << " values.");
  ASPERITY_REQUIRE(rows.values.size() >= 2, path_ << ": a table needs two rows or more, but has "
                                                  << rows.values.size() << ".");
  requireNumbers(rows, path_);
  requireOrder(rows, rule.interpolation, path_);
  arguments_ = std::move(rows.arguments);
  values_ = std::move(rows.values);
  value_unit_ = std::move(rows.value_unit);
}

double TableFunction::operator()(double argument) const
{
  if (std::isnan(argument) || (argument >= arguments_.front() && argument <= arguments_.back())) {
    return inside(argument);
  }
  switch (rule_.outside) {
  case Outside::nearest: return argument < arguments_.front() ? values_.front() : values_.back();
  case Outside::value: return rule_.value_outside;
  case Outside::error: break;
  }
  throw InputError(path_ + " has arguments from " + formatNumber(arguments_.front()) + " to " +
                   formatNumber(arguments_.back()) + ", but " + formatNumber(argument) +
                   " is wanted. Add rows, or let Outside be 'Nearest' or 'Value'.");
}

double TableFunction::inside(double argument) const
{
  if (std::isnan(argument)) {
    return argument;
  }
  const auto next = std::upper_bound(arguments_.begin(), arguments_.end(), argument);
  const auto row = static_cast<std::size_t>(next - arguments_.begin()) - 1;
  if (rule_.interpolation == Interpolation::step || next == arguments_.end()) {
    return values_[row];
  }
  const double behind_row = argument - arguments_[row];
  const double to_next = *next - argument;
  if (rule_.interpolation == Interpolation::nearest) {
    return values_[behind_row < to_next ? row : row + 1];
  }
  return values_[row] + behind_row / (*next - arguments_[row]) * (values_[row + 1] - values_[row]);
}
} // namespace asperity
