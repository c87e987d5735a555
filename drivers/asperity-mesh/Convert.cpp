#include "Commands.hpp"
#include "GmshSession.hpp"
#include "Meshes.hpp"
#include "TargetFolder.hpp"
#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/TouchingFacets.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace
{
template <int Dim>
std::string extents(asperity::GlobalMesh<Dim> const& mesh)
{
  std::string text;
  for (int d = 0; d < Dim; ++d) {
    const auto [low, high] =
      std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                          [d](auto const& a, auto const& b) { return a[d] < b[d]; });
    text += (d == 0 ? "" : ", ") + std::string(1, "xyz"[d]) + " from " +
            asperity::formatShort((*low)[d]) + " to " + asperity::formatShort((*high)[d]) + " m";
  }
  return text;
}

template <int Dim>
void writeConverted(asperity::GlobalMesh<Dim> const& mesh, std::string const& where,
                    std::string const& file_name)
{
  if (const auto touching = asperity::mesh::touchingFacets(mesh)) {
    warn(where + ": " + asperity::mesh::sentence(*touching));
  }
  auto split = mesh; // to find faults that cannot be split here, and not when the mesh is used
  asperity::mesh::splitFaults(split, where);
  const std::size_t regions = mesh.region_names.size(), faults = split.faults.size();
  writeAndReport(mesh, file_name,
                 ", " + std::to_string(regions) + " regions, " +
                   std::to_string(mesh.boundaries.size() - faults) + " boundaries, " +
                   std::to_string(faults) + " faults");
  std::cout << extents(mesh) << '\n';
}

// To metres.
double factor(std::string const& units, std::optional<double> const& scale)
{
  ASPERITY_REQUIRE(!scale || *scale > 0, "Option --scale = " << asperity::formatNumber(*scale)
                                                             << " is outside (0, inf).");
  ASPERITY_REQUIRE(units.empty() || units == "m" || units == "km",
                   "Option --units = " << units
                                       << " is neither m nor km. For other units give --scale, "
                                          "their size in metres.");
  ASPERITY_REQUIRE(units.empty() || !scale,
                   "Options --units and --scale are both given. Give one of them.");
  return scale.value_or(units == "km" ? 1000 : 1);
}

// "IN.geo, IN.msh or IN.puml.h5"
std::string alternatives(std::vector<std::string> const& endings, std::string const& name)
{
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < endings.size() ? ", " : " or ") + name + endings[i];
  }
  return text;
}
} // namespace

void convert(Arguments& arguments)
{
  std::vector<std::string> settings, names, region_names, without;
  std::string units, array;
  std::optional<double> scale;
  bool simplices = false;
  arguments.values("--set", settings, "NAME=VALUE", "replace a number of DefineConstant in a .geo")
    .values("--names", names, "NUMBER=NAME,...",
            "names of boundaries and faults by the numbers that the file has for them, as "
            "\"1=free,3=fault,5=far\", or by their names there, as \"old=new\"; groups without a "
            "name are called boundary_1, boundary_3, codes of SeisSol by their meaning, as "
            "free_surface and fault")
    .values("--region-names", region_names, "NUMBER=NAME,...", "the same for regions")
    .values("--without", without, "NAME,...", "leave out these boundaries or faults")
    .value("--units", units, "m|km", "unit of the coordinates (m)")
    .value("--array", array, "NAME",
           "of VTK: cell data with the numbers of regions and boundaries");
  arguments.number("--scale", scale, "factor of all coordinates to metres, instead of --units");
  arguments.flag("--simplices", simplices,
                 "cut quadrilaterals, hexahedra, prisms and pyramids into triangles and "
                 "tetrahedra, and leave out nodes of second order");
  arguments.overwrite();
  if (!arguments.read({alternatives(knownEndings(), "IN"), "OUT.h5"})) {
    return;
  }
  auto const& from = arguments.file(0);
  auto const& to = arguments.file(1);
  const GroupNames groups(names, region_names, without);
  const AssemblyOptions assembly = {factor(units, scale), simplices, groups.without};
  const ReadOptions options = {groups, assembly, settings, to, array};
  arguments.requireNew(to);
  const std::string where = "'" + from + "'";
  const auto [format, ending] = formatOf(from);
  ASPERITY_REQUIRE(settings.empty() || format->isGeometry(ending),
                   "Option --set " << settings.front() << ": mesh file " << where
                                   << " is no geometry (.geo), but a mesh.");
  requireFolder(to);
  const auto mesh = format->read(from, options);
  std::visit([&](auto const& any) { writeConverted(any, where, to); }, mesh);
}
