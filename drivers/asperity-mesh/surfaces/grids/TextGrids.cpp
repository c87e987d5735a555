#include "surfaces/files/TextFile.hpp"
#include "surfaces/grids/GridFormats.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace asperity::geometry
{
namespace
{
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::string lowerCase(std::string_view word)
{
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

double numberOrNan(TextFile const& file, std::size_t i)
{
  return lowerCase(file.word(i)) == "nan" ? no_value : file.number(i);
}

// Header "ncols 3", "nrows 2", "xllcorner 0", "yllcorner 0", "cellsize 10", "NODATA_value -9999",
// then the values row by row, the northern row first, cells in the middle of which they stand.
class EsriReader
{
public:
  explicit EsriReader(std::string const& file_name) : file_(file_name, "Grid file") {}

  GridData run()
  {
    readHeader();
    const std::size_t num_x = count("ncols"), num_y = count("nrows");
    ASPERITY_REQUIRE(static_cast<double>(num_x) * static_cast<double>(num_y) <=
                       static_cast<double>(file_.size()) / 2,
                     file_.where() << " is too small for the " << num_x << " x " << num_y
                                   << " values that its header names: it is cut or damaged.");
    std::vector<double> z;
    z.reserve(num_x * num_y);
    do {
      for (std::size_t i = 0; i < file_.words().size(); ++i) {
        const double value = numberOrNan(file_, i);
        z.push_back(has("nodata_value") && value == header_.at("nodata_value") ? no_value : value);
      }
    } while (z.size() < num_x * num_y && file_.next());
    ASPERITY_REQUIRE(z.size() == num_x * num_y,
                     file_.where() << " has " << z.size() << " values instead of " << num_x << " x "
                                   << num_y << ": it is cut or damaged.");
    auto y = axis("yllcenter", "yllcorner", "dy", num_y);
    std::reverse(y.begin(), y.end());
    return {
      Grid(axis("xllcenter", "xllcorner", "dx", num_x), y, std::move(z), false, file_.where()), "",
      0, false};
  }

private:
  void readHeader()
  {
    while (file_.next() && std::isalpha(static_cast<unsigned char>(file_.word(0)[0])) != 0 &&
           lowerCase(file_.word(0)) != "nan") {
      file_.require(2, "ncols 100");
      header_[lowerCase(file_.word(0))] = numberOrNan(file_, 1);
    }
  }

  bool has(std::string const& name) const { return header_.count(name) > 0; }

  double value(std::string const& name) const
  {
    ASPERITY_REQUIRE(has(name), file_.where() << " has no line '" << name
                                              << "' in its header. Is it an ESRI ascii grid?");
    return header_.at(name);
  }

  std::size_t count(std::string const& name) const
  {
    const double number = value(name);
    ASPERITY_REQUIRE(number >= 2 && number <= 1e9 && number == std::floor(number),
                     file_.where() << ": " << name << " = " << formatNumber(number)
                                   << " is no whole number from 2 on.");
    return static_cast<std::size_t>(number);
  }

  std::vector<double> axis(std::string const& centre, std::string const& corner,
                           std::string const& own_step, std::size_t size) const
  {
    const double step = has(own_step) ? value(own_step) : value("cellsize");
    ASPERITY_REQUIRE(step > 0, file_.where() << ": the cell size " << formatNumber(step)
                                             << " is outside (0, inf).");
    const double first = has(centre) ? value(centre) : value(corner) + step / 2;
    std::vector<double> values(size);
    for (std::size_t i = 0; i < size; ++i) {
      values[i] = first + step * static_cast<double>(i);
    }
    return values;
  }

  TextFile file_;
  std::map<std::string, double> header_;
};

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
} // namespace

GridData readEsriGrid(std::string const& file_name, std::string const& /*variable*/)
{
  return EsriReader(file_name).run();
}

GridData readPointGrid(std::string const& file_name, std::string const& /*variable*/)
{
  TextFile file(file_name, "Grid file", '#');
  std::vector<double> x, y, z;
  while (file.next()) {
    file.require(3, "x y z");
    x.push_back(file.number(0));
    y.push_back(file.number(1));
    z.push_back(numberOrNan(file, 2));
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
  std::vector<double> values(xs.size() * ys.size(), no_value);
  for (std::size_t i = 0; i < x.size(); ++i) {
    values[nearest(ys, y[i]) * xs.size() + nearest(xs, x[i])] = z[i];
  }
  return {Grid(xs, ys, std::move(values), false, file.where()), "", 0, false};
}
} // namespace asperity::geometry
