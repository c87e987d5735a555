#include "Arguments.hpp"
#include "Commands.hpp"
#include "Generation.hpp"

#include "mesh/generation/RectangleMesh.hpp"

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
} // namespace

std::string rectangleOptions()
{
  return "    --width, --height       along x and y, m (1)\n"
         "    --cells-x, --cells-y    columns and rows of two triangles each (1)\n"
         "    --left, --bottom        x and y of the lower left corner, m (0)\n"
         "    --cell-size             longest leg of the triangles, m, a formula in x and y\n"
         "    --fault                 \"NAME=CONDITION\", a fault inside, as \"main=abs(y) < "
         "1e-6\";\n"
         "                            cells have their edges along it; may be repeated\n";
}

void makeRectangle(std::vector<std::string> const& words)
{
  const auto arguments = parseArguments(
    words, {{"OUT.h5"},
            {"--width", "--height", "--cells-x", "--cells-y", "--left", "--bottom", "--cell-size"},
            {"--overwrite"},
            {"--fault"}});
  requireNew(arguments.files[0], arguments);
  auto const shape = shapeFrom(arguments);
  const asperity::Point<2> brick = {shape.width / shape.cells_x, shape.height / shape.cells_y};
  const auto mesh = graded<2>(asperity::mesh::rectangleMesh(shape), brick, arguments);
  writeAndReport(withFaults(mesh, arguments), arguments.files[0]);
}
