#include "catalogue/stress/CoulombPlanes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "io/OutputSet.hpp"
#include "parameters/Entries.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

namespace asperity::catalogue
{
namespace
{
constexpr char const* planes_list = "Coulomb Planes";
constexpr char const* path = "Asperity / Output / ";

// It joins those of the list.
Entries<DirectionEast> eastEntries(ParameterList& output)
{
  Entries<DirectionEast> entries({}, output);
  entries.realArray(
    "East", &DirectionEast::east, "-", Range::any(),
    "In three dimensions the part of this vector that is perpendicular to Up points east; "
    "strikes of Coulomb Planes follow from it. Its length has no effect.");
  return entries;
}

std::array<double, 3> eastOf(ParameterList const& output)
{
  auto const given = DirectionEast::from(output).east;
  ASPERITY_REQUIRE(given.size() == 3 && std::hypot(given[0], given[1], given[2]) > 0,
                   path << "East has to be three numbers, not all of them zero.");
  return {given[0], given[1], given[2]};
}

void requireFieldName(std::string const& name)
{
  ASPERITY_REQUIRE(std::all_of(name.begin(), name.end(),
                               [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }),
                   path << planes_list << ": a plane cannot be called '" << name
                        << "', because a field is named after it. Use letters, digits and '_'.");
}

void requireNumbers(std::string const& name, std::vector<double> const& numbers, int dimension)
{
  const std::size_t count = dimension == 3 ? 4 : 3;
  char const* meaning =
    dimension == 3 ? "strike, dip, rake [deg] and friction" : "angle, rake [deg] and friction";
  ASPERITY_REQUIRE(numbers.size() == count, path << planes_list << " / " << name << " has "
                                                 << numbers.size() << " numbers; in " << dimension
                                                 << " dimensions it needs " << count << ": "
                                                 << meaning << '.');
  ASPERITY_REQUIRE(numbers.back() >= 0 && numbers.back() <= 1,
                   path << planes_list << " / " << name << ": the friction "
                        << formatShort(numbers.back())
                        << " is outside [0, 1]. Rock has 0.2 to 0.8.");
  ASPERITY_REQUIRE(dimension == 2 || (numbers[1] >= 0 && numbers[1] <= 90),
                   path << planes_list << " / " << name << ": the dip " << formatShort(numbers[1])
                        << " is outside [0, 90] degrees. A plane that dips to the left of its "
                           "strike has the opposite strike.");
}

fem::CoulombPlane inSpace(ParameterList const& output, std::vector<double> const& numbers)
{
  auto const up = io::DirectionUp::from(output).orDefault();
  auto const east = eastOf(output);
  const double along = up[0] * east[0] + up[1] * east[1] + up[2] * east[2];
  const double sizes = std::hypot(up[0], up[1], up[2]) * std::hypot(east[0], east[1], east[2]);
  ASPERITY_REQUIRE(std::abs(along) < 0.999999 * sizes,
                   path << "East is parallel to Up. Strikes need a horizontal direction.");
  return fem::CoulombPlane::inSpace(numbers[0], numbers[1], numbers[2], numbers[3], up, east);
}
// Whether an array of texts in the list, or in one below it, has this one.
bool names(ParameterList const& list, std::string const& text)
{
  return std::any_of(list.begin(), list.end(), [&](auto const& item) {
    auto const& entry = item.second;
    if (entry.isList()) {
      return names(list.sublist(item.first), text);
    }
    if (!entry.template isType<Teuchos::Array<std::string>>()) {
      return false;
    }
    auto const& texts = Teuchos::getValue<Teuchos::Array<std::string>>(entry);
    return std::find(texts.begin(), texts.end(), text) != texts.end();
  });
}
} // namespace

void declareCoulombPlanes(Declare& output)
{
  auto const plane =
    Declare()
      .realArray("<plane>", required, "deg", Range::any(),
                 "In three dimensions these are strike, dip and rake in degrees (Aki and Richards: "
                 "the strike counts clockwise from north, the plane dips to its right, the hanging "
                 "wall slips along the rake) and the effective friction coefficient. In two they "
                 "are the angle of the plane from +x towards +y, the rake of the side on its "
                 "right, 0 along that direction and 90 along +z, both in degrees, and the "
                 "coefficient.")
      .list();
  output.openSublist(planes_list, plane,
                     "Each entry is a plane, and its name gives the field "
                     "coulomb_stress_change_<plane> of Volume Snapshots, Surface History and "
                     "Receivers in the body.");
  eastEntries(*output.list());
}

DirectionEast DirectionEast::from(ParameterList const& output)
{
  ParameterList declared;
  return eastEntries(declared).read(output, "Asperity / Output");
}

std::map<std::string, fem::CoulombPlane> coulombPlanes(ParameterList const& output, int dimension)
{
  std::map<std::string, fem::CoulombPlane> planes;
  auto const& list = output.sublist(planes_list);
  for (auto const& entry : list) {
    auto const& name = entry.first;
    auto const numbers = list.get<Teuchos::Array<double>>(name).toVector();
    requireFieldName(name);
    requireNumbers(name, numbers, dimension);
    planes[name] = dimension == 3 ? inSpace(output, numbers)
                                  : fem::CoulombPlane::inPlane(numbers[0], numbers[1], numbers[2]);
  }
  return planes;
}

std::vector<std::string> unwrittenPlanes(ParameterList const& output)
{
  std::vector<std::string> result;
  for (auto const& entry : output.sublist(planes_list)) {
    if (!names(output, coulombField(entry.first))) {
      result.push_back(entry.first);
    }
  }
  return result;
}
} // namespace asperity::catalogue
