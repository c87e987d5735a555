#include "surfaces/grids/Grid.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::geometry
{
namespace
{
// Reverses a decreasing axis; returns whether it did so.
bool makeIncreasing(std::vector<double>& axis, char const* name, std::string const& where)
{
  ASPERITY_REQUIRE(axis.size() >= 2, where << ": axis " << name << " has " << axis.size()
                                           << " values; two or more are needed.");
  const bool turns = axis.front() > axis.back();
  if (turns) {
    std::reverse(axis.begin(), axis.end());
  }
  for (std::size_t i = 0; i < axis.size(); ++i) {
    ASPERITY_REQUIRE(std::isfinite(axis[i]) && (i == 0 || axis[i] > axis[i - 1]),
                     where << ": the values of axis " << name
                           << " do not go in one direction: " << formatShort(axis[i])
                           << " stands beside " << formatShort(axis[i == 0 ? 1 : i - 1]) << ".");
  }
  return turns;
}

std::vector<std::size_t> everyLine(std::size_t size, std::size_t stride)
{
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i + 1 < size; i += stride) {
    lines.push_back(i);
  }
  lines.push_back(size - 1);
  return lines;
}
} // namespace

Grid::Grid(std::vector<double> x, std::vector<double> y, std::vector<double> z, bool is_periodic,
           std::string const& where)
    : x_(std::move(x))
    , y_(std::move(y))
    , z_(std::move(z))
    , is_periodic_(is_periodic)
    , where_(where)
{
  ASPERITY_ASSERT(z_.size() == x_.size() * y_.size());
  const auto width = static_cast<std::ptrdiff_t>(x_.size());
  const auto height = static_cast<std::ptrdiff_t>(y_.size());
  const bool turns_x = makeIncreasing(x_, "x", where), turns_y = makeIncreasing(y_, "y", where);
  for (std::ptrdiff_t j = 0; j < height && turns_x; ++j) {
    std::reverse(z_.begin() + j * width, z_.begin() + (j + 1) * width);
  }
  for (std::ptrdiff_t j = 0; j < height / 2 && turns_y; ++j) {
    std::swap_ranges(z_.begin() + j * width, z_.begin() + (j + 1) * width,
                     z_.begin() + (height - 1 - j) * width);
  }
}

Grid::Place Grid::place(std::vector<double> const& axis, double value, char const* name,
                        Outside outside) const
{
  // A place on the edge may lie outside by the rounding error of a projection and its inverse.
  const double slack = 1e-9 * (axis.back() - axis.front());
  ASPERITY_REQUIRE(
    outside == Outside::clamp || (value >= axis.front() - slack && value <= axis.back() + slack),
    where_ << " has no value at " << name << " = " << formatNumber(value) << "; it reaches from "
           << formatShort(axis.front()) << " to " << formatShort(axis.back())
           << ". Take a larger grid or a smaller area, or set Outside to Clamp.");
  const double within = std::clamp(value, axis.front(), axis.back());
  const auto above = std::upper_bound(axis.begin(), axis.end() - 1, within);
  const auto below =
    static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - axis.begin(), 1)) - 1;
  return {below, (within - axis[below]) / (axis[below + 1] - axis[below])};
}

double Grid::operator()(double x, double y, Outside outside) const
{
  double turned = x;
  if (is_periodic_) {
    constexpr double full_turn = 360;
    const double slack = 1e-9 * (x_.back() - x_.front());
    turned = x - full_turn * std::floor((x - (x_.front() - slack)) / full_turn);
    const double beyond = turned - x_.back(), before = x_.front() - (turned - full_turn);
    turned = beyond > before ? turned - full_turn : turned; // nearer to the other edge
  }
  const Place in_x = place(x_, turned, "x", outside), in_y = place(y_, y, "y", outside);
  double value = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t right = k % 2, up = k / 2;
    const double weight =
      (right == 1 ? in_x.share : 1 - in_x.share) * (up == 1 ? in_y.share : 1 - in_y.share);
    if (weight > 0) {
      value += weight * z(in_x.below + right, in_y.below + up);
    }
  }
  ASPERITY_REQUIRE(std::isfinite(value),
                   where_ << " is not defined at (" << formatNumber(x) << ", " << formatNumber(y)
                          << "). Fill its gaps, or take an area in which it is defined.");
  return value;
}

void Grid::scale(double factor)
{
  for (double& value : z_) {
    value *= factor;
  }
}

TriangleSurface Grid::surface(std::size_t stride) const
{
  const auto columns = everyLine(x_.size(), stride), rows = everyLine(y_.size(), stride);
  TriangleSurface result;
  std::vector<int> number(columns.size() * rows.size(), -1);
  const auto numberAt = [&](std::size_t i, std::size_t j) {
    return number[j * columns.size() + i];
  };
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double value = z(columns[i], rows[j]);
      if (std::isfinite(value)) {
        number[j * columns.size() + i] = static_cast<int>(result.points.size());
        result.points.push_back({x_[columns[i]], y_[rows[j]], value});
      }
    }
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
      std::vector<int> corners;
      for (const int corner :
           {numberAt(i, j), numberAt(i + 1, j), numberAt(i + 1, j + 1), numberAt(i, j + 1)}) {
        if (corner >= 0) {
          corners.push_back(corner);
        }
      }
      for (std::size_t k = 2; k < corners.size(); ++k) {
        result.triangles.push_back({corners[0], corners[k - 1], corners[k]});
      }
    }
  }
  return result;
}
} // namespace asperity::geometry
