#include "surfaces/files/BinaryFile.hpp"
#include "surfaces/grids/GridFormat.hpp"

#include "base/Errors.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
// Heights of a square degree [m], big-endian, row by row from the north-west corner; the name of
// the file has the south-west corner.
GridData readSrtm(std::string const& file_name)
{
  constexpr std::int16_t undefined = -32768;
  static const std::regex corner("([NSns])([0-9]{1,2})([EWew])([0-9]{1,3})");
  BinaryFile file(file_name, "Grid file");
  const std::string name = file_name.substr(file_name.find_last_of('/') + 1);
  std::smatch match;
  ASPERITY_REQUIRE(std::regex_search(name, match, corner),
                   file.where() << " has no corner in its name, as N34W119.hgt has: latitude 34 "
                                   "north, longitude 119 west, of its south-west corner.");
  const auto size =
    static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(file.size()) / 2)));
  ASPERITY_REQUIRE((size == 1201 || size == 3601) && file.size() == 2 * size * size,
                   file.where() << " has " << file.size()
                                << " bytes; a grid of 1201 x 1201 heights has 2884802, one of 3601 "
                                   "x 3601 has 25934402. Is it cut?");
  const bool is_south = match[1] == "S" || match[1] == "s";
  const bool is_west = match[3] == "W" || match[3] == "w";
  const double south = std::stod(match[2]) * (is_south ? -1 : 1);
  const double west = std::stod(match[4]) * (is_west ? -1 : 1);
  std::vector<double> x(size), y(size), z(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(size - 1);
    x[i] = west + share;
    y[i] = south + 1 - share;
  }
  std::vector<char> row(2 * size);
  for (std::size_t j = 0; j < size; ++j) {
    file.read(row.data(), row.size());
    for (std::size_t i = 0; i < size; ++i) {
      const auto height = fromBytes<std::int16_t>(&row[2 * i], ByteOrder::big);
      z[j * size + i] = height == undefined ? std::numeric_limits<double>::quiet_NaN() : height;
    }
  }
  return {Grid(std::move(x), std::move(y), std::move(z), true, file.where()), "degrees", 1, false};
}

class Srtm final : public GridFormat
{
public:
  std::vector<std::string> endings() const override { return {".hgt"}; }
  GridData read(std::string const& file_name, std::string const& /*variable*/) const override
  {
    return readSrtm(file_name);
  }
};
} // namespace

ASPERITY_REGISTER(GridFormatRegistry, "SRTM", Srtm)
} // namespace asperity::geometry
