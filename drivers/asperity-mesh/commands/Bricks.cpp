#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"
#include "mesh/Mesh.hpp"
#include "mesh/PointText.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "parameters/fields/Expression.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asperity::geometry
{
// Rectangles and boxes, with options of the same names along each axis.
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

GlobalMesh<2> bricks(Point<2> const& size, std::array<int, 2> const& cells, Point<2> const& lowest)
{
  return mesh::rectangleMesh({size[0], size[1], cells[0], cells[1], lowest});
}

GlobalMesh<3> bricks(Point<3> const& size, std::array<int, 3> const& cells, Point<3> const& lowest)
{
  return mesh::boxMesh({size, cells, lowest});
}

// Call this before the mesh is graded: bisection keeps a periodic mesh periodic, but may refine the
// opposite sides of another mesh differently.
void makePeriodicAlong(std::string const& names, GlobalMesh<3>& mesh)
{
  for (auto const& name : split(names, ',')) {
    const auto axis = std::string("xyz").find(name);
    ASPERITY_REQUIRE(name.size() == 1 && axis != std::string::npos,
                     "Option --periodic: '" << name << "' is not x, y or z.");
    mesh::makePeriodic(mesh, static_cast<int>(axis), axes[axis].low_boundary,
                       axes[axis].high_boundary);
  }
}

// A formula in the coordinates; `where` is for messages.
template <int Dim>
std::function<double(Point<Dim> const&)> formula(std::string const& text, std::string const& where)
{
  const auto expression = std::make_shared<Expression>(text, where);
  ASPERITY_REQUIRE(!expression->dependsOnTime(), where << " depends on t. Remove t from it.");
  return [expression](Point<Dim> const& x) {
    std::array<double, 3> point{};
    std::copy(x.begin(), x.end(), point.begin());
    return (*expression)(point, 0);
  };
}

// The mesh bisected until cells have this size, a formula as that of `Mesh / Cell Size` in a deck.
template <int Dim>
GlobalMesh<Dim> graded(GlobalMesh<Dim> const& mesh, Point<Dim> const& brick,
                       std::string const& cell_size)
{
  const auto size = formula<Dim>(cell_size, "Option --cell-size");
  return mesh::bisectBricks<Dim>(mesh, brick, [&](Point<Dim> const& x) {
    const double value = size(x);
    ASPERITY_REQUIRE(value > 0, "Option --cell-size is "
                                  << formatNumber(value) << " at "
                                  << (Dim == 2 ? "(x, y) = " : "(x, y, z) = ") << mesh::text(x)
                                  << " m, outside (0, inf).");
    return value;
  });
}

// From "NAME=CONDITION".
template <int Dim>
mesh::NamedCondition<Dim> faultFrom(std::string const& setting)
{
  const auto equals = setting.find('=');
  const std::string name = trimmed(setting.substr(0, equals));
  ASPERITY_REQUIRE(equals != std::string::npos && !name.empty(),
                   "Option --fault " << setting << " is not of the form NAME=CONDITION.");
  const auto condition = formula<Dim>(setting.substr(equals + 1), "Option --fault " + name);
  return {name, [condition](Point<Dim> const& x) { return condition(x) != 0; }};
}

// Adds faults. The file has them unsplit; a copy of the mesh is split to find errors.
template <int Dim>
void addFaults(GlobalMesh<Dim>& mesh, std::vector<std::string> const& settings)
{
  std::vector<mesh::NamedCondition<Dim>> faults;
  for (auto const& setting : settings) {
    faults.push_back(faultFrom<Dim>(setting));
  }
  mesh::addFaults(mesh, faults, "Option --fault");
  if (!faults.empty()) {
    auto trial = mesh;
    mesh::splitFaults(trial, "Option --fault");
  }
}

template <int Dim>
class Bricks final : public Command
{
public:
  Bricks()
  {
    size_.fill(1);
    cells_.fill(1);
  }

  CommandText text() const override
  {
    return {Dim == 2 ? "rectangle" : "box",
            "OUT.h5",
            Dim == 2 ? "Makes a rectangle of right triangles, graded by bisection."
                     : "Makes a box of bricks of six tetrahedra each, graded by bisection.",
            {"OUT.h5"}};
  }

  void declareOptions(Arguments& arguments) override
  {
    const std::string pieces = Dim == 2 ? "two triangles" : "six tetrahedra";
    for (int d = 0; d < Dim; ++d) {
      const std::string name(1, "xyz"[d]);
      arguments.number(axes[d].size, size_[d], "along " + name + ", m")
        .number(axes[d].cells, cells_[d], "number of bricks of " + pieces)
        .number(axes[d].lowest, lowest_[d], "smallest " + name + ", m");
    }
    if (Dim == 3) {
      arguments.value("--periodic", periodic_, "AXES",
                      "as \"z\" or \"x, z\"; at least 3 bricks along them");
    }
    arguments.value("--cell-size", cell_size_, "FORMULA",
                    std::string("longest side of the bricks, m, in ") +
                      (Dim == 2 ? "x and y" : "x, y and z"));
    arguments.values(
      "--fault", faults_, "NAME=CONDITION",
      "a fault inside, as \"main=abs(y) < 1e-6\", along which cells have their edges");
    arguments.overwrite();
  }

  void run(Arguments const& arguments) override
  {
    arguments.requireNew(arguments.file(0));
    auto mesh = bricks(size_, cells_, lowest_);
    if constexpr (Dim == 3) {
      if (!periodic_.empty()) {
        makePeriodicAlong(periodic_, mesh);
      }
    }
    if (!cell_size_.empty()) {
      Point<Dim> brick;
      for (int d = 0; d < Dim; ++d) {
        brick[d] = size_[d] / cells_[d];
      }
      mesh = graded<Dim>(mesh, brick, cell_size_);
    }
    addFaults(mesh, faults_);
    writeAndReport(mesh, arguments.file(0));
  }

private:
  Point<Dim> size_, lowest_{};
  std::array<int, Dim> cells_;
  std::string periodic_, cell_size_;
  std::vector<std::string> faults_;
};
} // namespace

std::unique_ptr<Command> rectangleCommand() { return std::make_unique<Bricks<2>>(); }
std::unique_ptr<Command> boxCommand() { return std::make_unique<Bricks<3>>(); }
} // namespace asperity::geometry
