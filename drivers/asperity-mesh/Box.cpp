#include "Commands.hpp"
#include "Generation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"

using asperity::mesh::BoxShape;

namespace
{
struct Axis
{
  char const* size;
  char const* cells;
  char const* lowest;
  char const* low_boundary;
  char const* high_boundary;
};

constexpr Axis axes[] = {{"--width", "--cells-x", "--left", "left", "right"},
                         {"--height", "--cells-y", "--bottom", "bottom", "top"},
                         {"--depth", "--cells-z", "--front", "front", "back"}};

BoxShape shapeFrom(Arguments const& arguments)
{
  BoxShape shape;
  for (int d = 0; d < 3; ++d) {
    shape.size[d] = arguments.number(axes[d].size, shape.size[d]);
    shape.num_cells[d] = arguments.integer(axes[d].cells, shape.num_cells[d]);
    shape.lowest_corner[d] = arguments.number(axes[d].lowest, shape.lowest_corner[d]);
  }
  return shape;
}

// Call this before the mesh is graded: bisection keeps a periodic mesh periodic, but may refine the
// opposite sides of another mesh differently.
void makePeriodicAlong(std::string const& names, asperity::GlobalMesh<3>& mesh)
{
  for (auto const& name : asperity::split(names, ',')) {
    const auto axis = std::string("xyz").find(name);
    ASPERITY_REQUIRE(name.size() == 1 && axis != std::string::npos,
                     "Option --periodic: '" << name << "' is not x, y or z.");
    asperity::mesh::makePeriodic(mesh, static_cast<int>(axis), axes[axis].low_boundary,
                                 axes[axis].high_boundary);
  }
}
} // namespace

std::string boxOptions()
{
  return "    --width, --height, --depth           along x, y and z, m (1)\n"
         "    --cells-x, --cells-y, --cells-z      numbers of bricks (1)\n"
         "    --left, --bottom, --front            smallest x, y and z, m (0)\n"
         "    --periodic              axes, as 'z' or 'x, z'; at least 3 bricks along them\n"
         "    --cell-size             longest side of the bricks, m, a formula in x, y and z\n"
         "    --fault                 \"NAME=CONDITION\", a fault inside, as \"main=abs(y) < "
         "1e-6\";\n"
         "                            cells have their edges along it; may be repeated\n";
}

void makeBox(std::vector<std::string> const& words)
{
  AllowedArguments allowed{{"OUT.h5"}, {"--periodic", "--cell-size"}, {"--overwrite"}, {"--fault"}};
  for (auto const& axis : axes) {
    allowed.options.insert(allowed.options.end(), {axis.size, axis.cells, axis.lowest});
  }
  const auto arguments = parseArguments(words, allowed);
  requireNew(arguments.files[0], arguments);
  auto const shape = shapeFrom(arguments);
  auto coarse = asperity::mesh::boxMesh(shape);
  if (arguments.has("--periodic")) {
    makePeriodicAlong(arguments.options.at("--periodic"), coarse);
  }
  asperity::Point<3> brick;
  for (int d = 0; d < 3; ++d) {
    brick[d] = shape.size[d] / shape.num_cells[d];
  }
  writeAndReport(withFaults(graded<3>(coarse, brick, arguments), arguments), arguments.files[0]);
}
