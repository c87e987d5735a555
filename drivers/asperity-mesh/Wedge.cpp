#include "Arguments.hpp"
#include "Commands.hpp"
#include "Generation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"

using asperity::mesh::DeepWedge;
using asperity::mesh::WedgeShape;

namespace
{
struct Parameter
{
  char const* option;
  double WedgeShape::*value;
  char const* meaning;
};

constexpr Parameter parameters[] = {
  {"--cell-size", &WedgeShape::cell_size, "largest diameter of cells at the seismogenic zone, m"},
  {"--growth-factor", &WedgeShape::growth_factor,
   "relative growth of cells over one growth length"},
  {"--growth-length", &WedgeShape::growth_length,
   "distance from the zone over which cells grow, m"},
  {"--length", &WedgeShape::length, "of the surface, m"},
  {"--height", &WedgeShape::height, "of the right face, m"},
  {"--zone-width", &WedgeShape::zone_width, "of the seismogenic zone along the base, m"},
  {"--zone-end", &WedgeShape::zone_end, "its lower end, along the surface from the trench, m"},
  {"--viscous-thickness", &WedgeShape::viscous_thickness, "of the region 'lower', m"},
};

// "0.05 to 0.25, 0.35 to 0.55"
std::vector<std::array<double, 2>> patchesFrom(std::string const& text)
{
  std::vector<std::array<double, 2>> patches;
  for (auto const& piece : asperity::split(text, ',')) {
    const auto middle = piece.find(" to ");
    const auto low = asperity::readNumber(asperity::trimmed(piece.substr(0, middle)));
    const auto high = middle == std::string::npos
                        ? std::nullopt
                        : asperity::readNumber(asperity::trimmed(piece.substr(middle + 4)));
    ASPERITY_REQUIRE(low && high, "Option --patches: '" << piece << "' is no interval of z. Write "
                                                        << "'0.05 to 0.25, 0.35 to 0.55'.");
    patches.push_back({*low, *high});
  }
  return patches;
}

asperity::GlobalMesh<3> wedgeWithDepth(WedgeShape const& shape, Arguments const& arguments)
{
  DeepWedge deep;
  deep.depth = arguments.number("--depth", deep.depth);
  deep.is_periodic = arguments.has("--periodic");
  if (!arguments.has("--layers")) {
    if (arguments.has("--patches")) {
      deep.patches = patchesFrom(arguments.options.at("--patches"));
    }
    return deepWedgeMesh(shape, deep);
  }
  ASPERITY_REQUIRE(
    !arguments.has("--patches"),
    "Option --patches cannot be combined with --layers, whose layers are all alike.");
  auto mesh = layeredWedgeMesh(shape, deep.depth, arguments.integer("--layers", 1));
  if (deep.is_periodic) {
    asperity::mesh::makePeriodic(mesh, 2, "front", "back");
  }
  return mesh;
}
} // namespace

std::string wedgeOptions()
{
  std::string lines;
  for (auto const& parameter : parameters) {
    std::string line = std::string("    ") + parameter.option;
    line.resize(28, ' ');
    lines += line + parameter.meaning + " (" +
             asperity::formatNumber(WedgeShape().*parameter.value) + ")\n";
  }
  return lines + "    --depth                 along z, m: tetrahedra instead of triangles\n"
                 "    --patches               z of the seismogenic zone, m (the whole depth), as\n"
                 "                            '0.05 to 0.25, 0.35 to 0.55'\n"
                 "    --layers                number of equal layers of the plane wedge, instead\n"
                 "    --periodic              along z; takes no value\n";
}

void makeWedge(std::vector<std::string> const& words)
{
  AllowedArguments allowed{
    {"OUT.h5"}, {"--depth", "--patches", "--layers"}, {"--overwrite", "--periodic"}};
  for (auto const& parameter : parameters) {
    allowed.options.emplace_back(parameter.option);
  }
  const auto arguments = parseArguments(words, allowed);
  requireNew(arguments.files[0], arguments);
  WedgeShape shape;
  for (auto const& parameter : parameters) {
    shape.*parameter.value = arguments.number(parameter.option, shape.*parameter.value);
  }
  if (arguments.has("--depth")) {
    writeAndReport(wedgeWithDepth(shape, arguments), arguments.files[0]);
    return;
  }
  for (char const* option : {"--patches", "--layers", "--periodic"}) {
    ASPERITY_REQUIRE(!arguments.has(option), "Option " << option << " needs --depth too.");
  }
  writeAndReport(asperity::mesh::wedgeMesh(shape), arguments.files[0]);
}
