#include "surfaces/Contours.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"
#include "surfaces/kinds/Units.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
constexpr char const* contours_file = "Contours File";
constexpr char const* lower_depth = "Lower Depth";

Teuchos::RCP<const ParameterList> contoursEntries()
{
  Declare declare;
  declare
    .fileName(contours_file, required,
              "The contours are in this file, in any order and direction: lines 'x y depth', or 'x "
              "y' below a line with the depth.")
    .real(lower_depth, optional, "m", Range::any(),
          "The surface ends at z = -Lower Depth; without this entry at the deepest contour.")
    .real("Spacing", 0., "m", Range::atLeast(0),
          "Points along strike have about this spacing; 0 makes it that of the contours.");
  declareExtendUp(declare, true);
  return Units::declare(declare).list();
}

TriangleSurface makeContours(ParameterList const& list, std::string const& path,
                             SurfaceContext const& context)
{
  const auto units = Units::read(list, path, context);
  const auto file = fileOf(list, contours_file, context);
  auto contours = readContours(file);
  double lowest = 0;
  for (auto& contour : contours) {
    units.toModel(contour);
    lowest = std::min(lowest, contour.front()[2]);
  }
  ContourOptions options;
  options.spacing = list.get<double>("Spacing");
  if (isGiven(list, lower_depth)) {
    options.lower_z = lowest = -list.get<double>(lower_depth);
  }
  if (list.get<bool>("Extend Up")) {
    options.upper_z = aboveGround(lowest, context);
  }
  return contourSurface(std::move(contours), options, "Contours file '" + file + "'",
                        context.remark);
}

class ContoursKind final : public SurfaceKind
{
public:
  std::vector<std::string> sources() const override { return {contours_file}; }
  std::string fileEntry() const override { return contours_file; }
  FileFit fit(std::string const& /*file_name*/) const override { return FileFit::possible; }
  Teuchos::RCP<const ParameterList> entries() const override { return contoursEntries(); }
  TriangleSurface make(ParameterList const& list, std::string const& path,
                       SurfaceContext const& context) const override
  {
    return makeContours(list, path, context);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceKindRegistry, "Contours", ContoursKind)
} // namespace asperity::geometry
