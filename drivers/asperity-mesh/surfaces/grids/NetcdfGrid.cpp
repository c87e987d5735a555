#include "surfaces/grids/GridFormat.hpp"
#include "surfaces/netcdf/NetcdfFile.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// Grids by the CF conventions. An axis is identified by its units, its standard name, its attribute
// `axis` or its name.
namespace asperity::geometry
{
namespace
{
bool isOneOf(std::string const& word, std::vector<std::string> const& words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string lengthOrDegrees(std::string const& unit)
{
  if (unit.rfind("degree", 0) == 0) {
    return "degrees";
  }
  return isOneOf(unit, {"m", "meter", "meters", "metre", "metres", "Meter", "Meters"}) ? "m"
         : isOneOf(unit, {"km", "kilometer", "kilometers", "kilometre", "kilometres"}) ? "km"
                                                                                       : "";
}

enum class Axis
{
  x,
  y,
  unknown
};

Axis axisOf(NetcdfVariable const& variable)
{
  const std::string units = variable.text("units"), standard = variable.text("standard_name");
  const std::string axis = variable.text("axis");
  std::string name = variable.name;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (isOneOf(units, {"degrees_east", "degree_east", "degree_E", "degrees_E", "degreeE"}) ||
      isOneOf(standard, {"longitude", "projection_x_coordinate", "grid_longitude"}) ||
      axis == "X" || isOneOf(name, {"lon", "longitude", "x", "easting"})) {
    return Axis::x;
  }
  if (isOneOf(units, {"degrees_north", "degree_north", "degree_N", "degrees_N", "degreeN"}) ||
      isOneOf(standard, {"latitude", "projection_y_coordinate", "grid_latitude"}) || axis == "Y" ||
      isOneOf(name, {"lat", "latitude", "y", "northing"})) {
    return Axis::y;
  }
  return Axis::unknown;
}

// Whether a variable has two dimensions, after leading dimensions of length 1 such as a time.
bool isPlane(NetcdfVariable const& variable)
{
  auto const& shape = variable.shape;
  return !variable.is_text && shape.size() >= 2 &&
         std::all_of(shape.begin(), shape.end() - 2, [](auto extent) { return extent == 1; });
}

class NetcdfGridReader
{
public:
  NetcdfGridReader(std::string const& file_name, std::string const& name)
      : file_(openNetcdf(file_name, "Grid file"))
      , variable_(choose(name))
      , where_(file_->where() + ", variable '" + variable_.name + "'")
  {
  }

  GridData run() const
  {
    NetcdfVariable const& last = coordinates(1, Axis::x);
    NetcdfVariable const& first = coordinates(0, Axis::y);
    const Axis fast = axisOf(last), slow = axisOf(first);
    const bool is_turned = fast == Axis::y && slow == Axis::x;
    ASPERITY_REQUIRE(is_turned || (fast == Axis::x && slow == Axis::y),
                     where_ << " has the axes '" << first.name << "' and '" << last.name
                            << "', and nothing says which one is x and which one is y. "
                               "Give them CF's attribute standard_name or axis.");
    auto const& x = is_turned ? first : last;
    auto const& y = is_turned ? last : first;
    auto z = values();
    if (is_turned) {
      z = transposed(z, y.shape[0]);
    }
    const std::string unit = horizontalUnit(x);
    ASPERITY_REQUIRE(unit == horizontalUnit(y), where_ << ": its axes have different units.");
    const std::string length = lengthOrDegrees(variable_.text("units"));
    return {
      Grid(file_->numbers(x.name), file_->numbers(y.name), std::move(z), unit == "degrees", where_),
      unit,
      length == "m"    ? 1.
      : length == "km" ? 1000.
                       : 0.,
      variable_.text("positive") == "down"};
  }

private:
  NetcdfVariable const& choose(std::string const& name) const
  {
    if (!name.empty()) {
      auto const& wanted = file_->variable(name);
      ASPERITY_REQUIRE(isPlane(wanted), file_->where() << ": variable '" << name
                                                       << "' is not a grid of two dimensions.");
      return wanted;
    }
    std::vector<std::string> names;
    for (auto const& each : file_->variables()) {
      if (isPlane(each)) {
        names.push_back(each.name);
      }
    }
    ASPERITY_REQUIRE(!names.empty(),
                     file_->where() << " has no variable of two dimensions. If it is a grid of an "
                                       "old GMT, convert it with gmt grdconvert.");
    ASPERITY_REQUIRE(names.size() == 1, file_->where()
                                          << " has several grids: " << quotedNames(names)
                                          << ". Name one of them by Variable.");
    return file_->variable(names.front());
  }

  // of the last dimension but one (0) or the last one (1)
  NetcdfVariable const& coordinates(std::size_t which, Axis usual) const
  {
    const std::size_t d = variable_.shape.size() - 2 + which;
    auto const& name = variable_.dimensions[d];
    if (!name.empty() && file_->has(name) && file_->variable(name).shape.size() == 1) {
      return file_->variable(name);
    }
    // A square grid may not tell its dimensions; then they stand in the usual order.
    for (auto const& each : file_->variables()) {
      if (name.empty() && each.shape == std::vector<std::uint64_t>{variable_.shape[d]} &&
          axisOf(each) == usual) {
        return each;
      }
    }
    throw InputError(where_ + ": dimension " + std::to_string(d + 1) + " '" + name +
                     "' has no coordinates, a variable of the same name.");
  }

  static std::string horizontalUnit(NetcdfVariable const& axis)
  {
    const auto standard = axis.text("standard_name");
    return standard == "longitude" || standard == "latitude" ? "degrees"
                                                             : lengthOrDegrees(axis.text("units"));
  }

  double number(std::string const& attribute, double otherwise) const
  {
    const auto found = variable_.attributes.find(attribute);
    return found == variable_.attributes.end() || found->second.numbers.empty()
             ? otherwise
             : found->second.numbers.front();
  }

  std::vector<double> values() const
  {
    constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
    const double fill = number("_FillValue", undefined), missing = number("missing_value", fill);
    const double factor = number("scale_factor", 1), offset = number("add_offset", 0);
    auto z = file_->numbers(variable_.name);
    for (double& value : z) {
      value = value == fill || value == missing || !std::isfinite(value) ? undefined
                                                                         : factor * value + offset;
    }
    return z;
  }

  // (num_x, num_y) to (num_y, num_x)
  static std::vector<double> transposed(std::vector<double> const& z, std::size_t num_y)
  {
    const std::size_t num_x = z.size() / num_y;
    std::vector<double> result(z.size());
    for (std::size_t i = 0; i < num_x; ++i) {
      for (std::size_t j = 0; j < num_y; ++j) {
        result[j * num_x + i] = z[i * num_y + j];
      }
    }
    return result;
  }

  std::unique_ptr<NetcdfFile> file_;
  NetcdfVariable const& variable_;
  std::string where_;
};

class NetcdfFormat final : public GridFormat
{
public:
  std::vector<std::string> endings() const override { return {".nc", ".grd", ".cdf"}; }
  bool hasVariables() const override { return true; }
  GridData read(std::string const& file_name, std::string const& variable) const override
  {
    return NetcdfGridReader(file_name, variable).run();
  }
};
} // namespace

ASPERITY_REGISTER(GridFormatRegistry, "netCDF", NetcdfFormat)
} // namespace asperity::geometry
