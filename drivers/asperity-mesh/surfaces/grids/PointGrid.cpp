#include "surfaces/files/TextFile.hpp"
#include "surfaces/grids/GridFormat.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
// The distinct values, sorted; those closer than a millionth of all are one.
std::vector<double> distinct(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const double least = 1e-6 * (values.back() - values.front());
  std::vector<double> result;
  for (const double value : values) {
    if (result.empty() || value - result.back() > least) {
      result.push_back(value);
    }
  }
  return result;
}

std::size_t nearest(std::vector<double> const& axis, double value)
{
  const auto above = std::lower_bound(axis.begin(), axis.end(), value);
  if (above == axis.begin()) {
    return 0;
  }
  const auto at = static_cast<std::size_t>(above - axis.begin());
  return at == axis.size() || value - axis[at - 1] < axis[at] - value ? at - 1 : at;
}

// Lines "x y z", in any order.
GridData readPoints(std::string const& file_name)
{
  TextFile file(file_name, "Grid file", '#');
  std::vector<double> x, y, z;
  while (file.next()) {
    file.require(3, "x y z");
    x.push_back(file.number(0));
    y.push_back(file.number(1));
    z.push_back(file.numberOrNan(2));
  }
  ASPERITY_REQUIRE(!x.empty(), file.where() << " has no point.");
  const auto xs = distinct(x), ys = distinct(y);
  constexpr double most_gaps = 4; // crossings of lines for each point
  ASPERITY_REQUIRE(static_cast<double>(xs.size()) * static_cast<double>(ys.size()) <=
                     most_gaps * static_cast<double>(x.size()),
                   file.where() << ": its " << x.size() << " points have " << xs.size()
                                << " different x and " << ys.size()
                                << " different y, so that they are no grid. Interpolate them to "
                                   "one, for example by gmt surface.");
  std::vector<double> values(xs.size() * ys.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < x.size(); ++i) {
    values[nearest(ys, y[i]) * xs.size() + nearest(xs, x[i])] = z[i];
  }
  return {Grid(xs, ys, std::move(values), false, file.where()), "", 0, false};
}

class PointGrid final : public GridFormat
{
public:
  std::vector<std::string> endings() const override { return {".xyz"}; }
  GridData read(std::string const& file_name, std::string const& /*variable*/) const override
  {
    return readPoints(file_name);
  }
};
} // namespace

ASPERITY_REGISTER(GridFormatRegistry, "points", PointGrid)
} // namespace asperity::geometry
