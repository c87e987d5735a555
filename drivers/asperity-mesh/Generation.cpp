#include "Generation.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "base/fields/Expression.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/generation/Bisection.hpp"

#include <algorithm>
#include <iostream>
#include <memory>

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

template <int Dim>
asperity::mesh::NamedCondition<Dim> faultFrom(std::string const& setting)
{
  const auto equals = setting.find('=');
  const std::string name = asperity::trimmed(setting.substr(0, equals));
  ASPERITY_REQUIRE(equals != std::string::npos && !name.empty(),
                   "Option --fault " << setting << " is not of the form NAME=CONDITION.");
  const auto condition =
    std::make_shared<asperity::Expression>(setting.substr(equals + 1), "Option --fault " + name);
  ASPERITY_REQUIRE(!condition->dependsOnTime(),
                   "Option --fault " << name << " depends on t. Remove t from it.");
  return {name, [condition](Point<Dim> const& x) {
            std::array<double, 3> point{};
            std::copy(x.begin(), x.end(), point.begin());
            return (*condition)(point, 0.0) != 0.0;
          }};
}
} // namespace

template <int Dim>
GlobalMesh<Dim> withFaults(GlobalMesh<Dim> mesh, Arguments const& arguments)
{
  std::vector<asperity::mesh::NamedCondition<Dim>> faults;
  for (auto const& setting : arguments.all("--fault")) {
    faults.push_back(faultFrom<Dim>(setting));
  }
  asperity::mesh::addFaults(mesh, faults, "Option --fault");
  if (!faults.empty()) {
    auto trial = mesh;
    asperity::mesh::splitFaults(trial, "Option --fault");
  }
  return mesh;
}

template <int Dim>
GlobalMesh<Dim> graded(GlobalMesh<Dim> const& mesh, Point<Dim> const& brick,
                       Arguments const& arguments)
{
  if (!arguments.has("--cell-size")) {
    return mesh;
  }
  const asperity::Expression size(arguments.options.at("--cell-size"), "Option --cell-size");
  ASPERITY_REQUIRE(!size.dependsOnTime(), "Option --cell-size depends on t. Remove t from it.");
  return asperity::mesh::bisectBricks<Dim>(
    mesh, brick, [&](Point<Dim> const& x) { return positiveSize<Dim>(size, x); });
}

template <int Dim>
void writeAndReport(GlobalMesh<Dim> const& mesh, std::string const& file_name)
{
  asperity::mesh::writeMesh(mesh, file_name);
  std::cout << file_name << ": " << mesh.vertices.size() << " vertices, " << mesh.cells.size()
            << " cells\n";
}

template GlobalMesh<2> graded<2>(GlobalMesh<2> const&, Point<2> const&, Arguments const&);
template GlobalMesh<3> graded<3>(GlobalMesh<3> const&, Point<3> const&, Arguments const&);
template GlobalMesh<2> withFaults(GlobalMesh<2>, Arguments const&);
template GlobalMesh<3> withFaults(GlobalMesh<3>, Arguments const&);
template void writeAndReport(GlobalMesh<2> const&, std::string const&);
template void writeAndReport(GlobalMesh<3> const&, std::string const&);
