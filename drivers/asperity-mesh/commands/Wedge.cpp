#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"

namespace asperity::geometry
{
namespace
{
// "0.05 to 0.25, 0.35 to 0.55"
std::vector<std::array<double, 2>> patchesFrom(std::string const& text)
{
  std::vector<std::array<double, 2>> patches;
  for (auto const& piece : split(text, ',')) {
    const auto middle = piece.find(" to ");
    const auto low = readNumber(trimmed(piece.substr(0, middle)));
    const auto high =
      middle == std::string::npos ? std::nullopt : readNumber(trimmed(piece.substr(middle + 4)));
    ASPERITY_REQUIRE(low && high, "Option --patches: '" << piece << "' is no interval of z. Write "
                                                        << "'0.05 to 0.25, 0.35 to 0.55'.");
    patches.push_back({*low, *high});
  }
  return patches;
}
} // namespace

void makeWedge(Arguments& arguments)
{
  mesh::WedgeShape shape;
  mesh::DeepWedge deep;
  std::optional<double> depth;
  std::optional<int> layers;
  std::string patches;
  arguments
    .number("--cell-size", shape.cell_size, "largest diameter of cells at the seismogenic zone, m")
    .number("--growth-factor", shape.growth_factor,
            "relative growth of cells over one growth length")
    .number("--growth-length", shape.growth_length,
            "distance from the zone over which cells grow, m")
    .number("--length", shape.length, "of the surface, m")
    .number("--height", shape.height, "of the right face, m")
    .number("--zone-width", shape.zone_width, "of the seismogenic zone along the base, m")
    .number("--zone-end", shape.zone_end, "its lower end, along the surface from the trench, m")
    .number("--viscous-thickness", shape.viscous_thickness, "of the region 'lower', m")
    .number("--depth", depth, "along z, m: tetrahedra instead of triangles")
    .number("--layers", layers, "with depth: number of equal layers of the plane wedge")
    .value("--patches", patches, "INTERVALS",
           "with depth: z of the seismogenic zone, m (all), as '0.05 to 0.25, 0.35 to 0.55'")
    .flag("--periodic", deep.is_periodic, "with depth: along z");
  arguments.overwrite();
  if (!arguments.read({"OUT.h5"})) {
    return;
  }
  auto const& file_name = arguments.file(0);
  arguments.requireNew(file_name);
  if (!depth) {
    char const* option = !patches.empty()   ? "--patches"
                         : layers           ? "--layers"
                         : deep.is_periodic ? "--periodic"
                                            : nullptr;
    ASPERITY_REQUIRE(option == nullptr, "Option " << option << " needs --depth too.");
    return writeAndReport(mesh::wedgeMesh(shape), file_name);
  }
  deep.depth = *depth;
  if (!layers) {
    if (!patches.empty()) {
      deep.patches = patchesFrom(patches);
    }
    return writeAndReport(deepWedgeMesh(shape, deep), file_name);
  }
  ASPERITY_REQUIRE(patches.empty(), "Option --patches cannot be combined with --layers, whose "
                                    "layers are all alike.");
  auto mesh = layeredWedgeMesh(shape, deep.depth, *layers);
  if (deep.is_periodic) {
    mesh::makePeriodic(mesh, 2, "front", "back");
  }
  writeAndReport(mesh, file_name);
}
} // namespace asperity::geometry
