#include "Arguments.hpp"
#include "Commands.hpp"

#include "base/Errors.hpp"
#include "base/Expression.hpp"
#include "base/Text.hpp"
#include "mesh/Bisection.hpp"
#include "mesh/MeshFile.hpp"
#include "mesh/RectangleMesh.hpp"

#include <iostream>

using asperity::GlobalMesh;
using asperity::Point;
using asperity::mesh::RectangleShape;

namespace
{
RectangleShape shapeFrom(Arguments const& arguments)
{
  RectangleShape shape;
  shape.width = arguments.number("--width", shape.width);
  shape.height = arguments.number("--height", shape.height);
  shape.cells_x = arguments.integer("--cells-x", shape.cells_x);
  shape.cells_y = arguments.integer("--cells-y", shape.cells_y);
  shape.lower_left[0] = arguments.number("--left", shape.lower_left[0]);
  shape.lower_left[1] = arguments.number("--bottom", shape.lower_left[1]);
  return shape;
}

GlobalMesh<2> graded(GlobalMesh<2> const& mesh, std::string const& cell_size)
{
  const asperity::Expression size(cell_size, "Option --cell-size");
  ASPERITY_REQUIRE(!size.dependsOnTime(), "Option --cell-size depends on t. Remove t from it.");
  const auto size_at = [&](Point<2> const& x) {
    const double value = size({x[0], x[1], 0.0}, 0.0);
    ASPERITY_REQUIRE(value > 0.0, "Option --cell-size is " << asperity::formatNumber(value)
                                                           << " at (x, y) = (" << x[0] << ", "
                                                           << x[1] << ") m, outside (0, inf).");
    return value;
  };
  return asperity::mesh::bisect(mesh, asperity::mesh::largestDiameter(size_at));
}
} // namespace

std::string rectangleOptions()
{
  return "    --width, --height       along x and y, m (1)\n"
         "    --cells-x, --cells-y    columns and rows of two triangles each (1)\n"
         "    --left, --bottom        x and y of the lower left corner, m (0)\n"
         "    --cell-size             legs of the triangles, m, a formula in x and y\n";
}

void makeRectangle(std::vector<std::string> const& words)
{
  const auto arguments = parseArguments(
    words, {{"OUT.h5"},
            {"--width", "--height", "--cells-x", "--cells-y", "--left", "--bottom", "--cell-size"},
            {"--overwrite"}});
  requireNew(arguments.files[0], arguments);
  auto mesh = asperity::mesh::rectangleMesh(shapeFrom(arguments));
  if (arguments.has("--cell-size")) {
    mesh = graded(mesh, arguments.options.at("--cell-size"));
  }
  asperity::mesh::writeMesh(mesh, arguments.files[0]);
  std::cout << arguments.files[0] << ": " << mesh.vertices.size() << " vertices, "
            << mesh.cells.size() << " cells\n";
}
