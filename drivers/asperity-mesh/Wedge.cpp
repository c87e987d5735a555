#include "Arguments.hpp"
#include "Commands.hpp"

#include "base/Text.hpp"
#include "mesh/MeshFile.hpp"
#include "mesh/WedgeMesh.hpp"

#include <iostream>

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
  {"--growth-factor", &WedgeShape::growth_factor, "cell sizes more per growth length away from it"},
  {"--growth-length", &WedgeShape::growth_length, "m"},
  {"--length", &WedgeShape::length, "of the surface, m"},
  {"--height", &WedgeShape::height, "of the right face, m"},
  {"--zone-width", &WedgeShape::zone_width, "of the seismogenic zone along the base, m"},
  {"--zone-end", &WedgeShape::zone_end, "its lower end, along the surface from the trench, m"},
  {"--viscous-thickness", &WedgeShape::viscous_thickness, "of the region 'lower', m"},
};
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
  return lines;
}

void makeWedge(std::vector<std::string> const& words)
{
  AllowedArguments allowed{{"OUT.h5"}, {}, {"--overwrite"}};
  for (auto const& parameter : parameters) {
    allowed.options.push_back(parameter.option);
  }
  const auto arguments = parseArguments(words, allowed);
  requireNew(arguments.files[0], arguments);
  WedgeShape shape;
  for (auto const& parameter : parameters) {
    shape.*parameter.value = arguments.number(parameter.option, shape.*parameter.value);
  }
  const auto mesh = asperity::mesh::wedgeMesh(shape);
  asperity::mesh::writeMesh(mesh, arguments.files[0]);
  std::cout << arguments.files[0] << ": " << mesh.vertices.size() << " vertices, "
            << mesh.cells.size() << " cells\n";
}
