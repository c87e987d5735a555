#include "surfaces/files/TextFile.hpp"
#include "surfaces/grids/GridFormat.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

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

// Header "ncols 3", "nrows 2", "xllcorner 0", "yllcorner 0", "cellsize 10", "NODATA_value -9999",
// then the values row by row, the northern row first. A value belongs to the centre of its cell.
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
        const double value = file_.numberOrNan(i);
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
      header_[lowerCase(file_.word(0))] = file_.numberOrNan(1);
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
                                   << " is not a whole number of at least 2.");
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

class EsriGrid final : public GridFormat
{
public:
  std::vector<std::string> endings() const override { return {".asc"}; }
  GridData read(std::string const& file_name, std::string const& /*variable*/) const override
  {
    return EsriReader(file_name).run();
  }
};
} // namespace

ASPERITY_REGISTER(GridFormatRegistry, "ESRI ascii", EsriGrid)
} // namespace asperity::geometry
