#include "Generation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/fields/Expression.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/generation/Bisection.hpp"

#include <algorithm>
#include <iostream>

using asperity::GlobalMesh;
using asperity::Point;

namespace
{
template <int Dim>
double positiveSize(asperity::Expression const& size, Point<Dim> const& x)
{
  std::array<double, 3> point{};
  std::copy(x.begin(), x.end(), point.begin());
  const double value = size(point, 0.0);
  if (!(value > 0.0)) {
    std::string place;
    for (double coordinate : x) {
      place += (place.empty() ? "(" : ", ") + asperity::formatShort(coordinate);
    }
    throw asperity::InputError("Option --cell-size is " + asperity::formatNumber(value) + " at " +
                               (Dim == 2 ? "(x, y)" : "(x, y, z)") + " = " + place +
                               ") m, outside (0, inf).");
  }
  return value;
}
} // namespace

template <int Dim>
GlobalMesh<Dim> graded(GlobalMesh<Dim> const& mesh, Arguments const& arguments)
{
  if (!arguments.has("--cell-size")) {
    return mesh;
  }
  const asperity::Expression size(arguments.options.at("--cell-size"), "Option --cell-size");
  ASPERITY_REQUIRE(!size.dependsOnTime(), "Option --cell-size depends on t. Remove t from it.");
  return asperity::mesh::bisect(mesh, asperity::mesh::largestDiameter([&](Point<Dim> const& x) {
                                  return positiveSize<Dim>(size, x);
                                }));
}

template <int Dim>
void writeAndReport(GlobalMesh<Dim> const& mesh, std::string const& file_name)
{
  asperity::mesh::writeMesh(mesh, file_name);
  std::cout << file_name << ": " << mesh.vertices.size() << " vertices, " << mesh.cells.size()
            << " cells\n";
}

template GlobalMesh<2> graded(GlobalMesh<2> const&, Arguments const&);
template GlobalMesh<3> graded(GlobalMesh<3> const&, Arguments const&);
template void writeAndReport(GlobalMesh<2> const&, std::string const&);
template void writeAndReport(GlobalMesh<3> const&, std::string const&);
