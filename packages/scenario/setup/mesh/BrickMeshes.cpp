#include "scenario/setup/mesh/Generators.hpp"

#include "base/Errors.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/FlatLayers.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "parameters/Entries.hpp"
#include "parameters/fields/Field.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The types Rectangle and Box, of rectangles or cuboids that are bisected or become flat.
namespace asperity::scenario
{
namespace
{
std::string flatCellsAt(int axis) { return std::string("Flat Cells at ") + "xyz"[axis]; }

// Of cells that are bisected or become flat.
struct CellSettings
{
  double size_factor = 1;
  std::array<std::optional<std::vector<double>>, 3> flat_at; // positions along each axis [m]
  double flat_height = 0.3;
};

template <class Settings>
void addFlatCells(Entries<Settings>& entries, int dimension)
{
  for (int axis = 0; axis < dimension; ++axis) {
    entries.realArray(
      flatCellsAt(axis), [axis](Settings & s) -> auto& { return s.flat_at[axis]; }, optional, "m",
      Range::any(),
      std::string("Cells beside the planes at these ") + "xyz"[axis] +
        " are flat, as faults want them; see 'Flat Cell Height'.");
  }
  entries.real(
    "Flat Cell Height", &CellSettings::flat_height, "-", Range::openClosed(0, 1),
    "Layers of cells beside the planes of 'Flat Cells at' are this times as high as without that "
    "entry, the next layers 1.5 times as much each, until they reach their own height. 'Cell Size' "
    "sees the positions before.");
}

// type: of the mesh
template <int Dim>
void flattenCells(CellSettings const& settings, std::string const& type, GlobalMesh<Dim>& mesh)
{
  for (int axis = 0; axis < Dim; ++axis) {
    if (auto const& positions = settings.flat_at[axis]) {
      auto const where = joinPath(joinPath(mesh_path, type), flatCellsAt(axis));
      ASPERITY_REQUIRE(mesh.period[axis] == 0,
                       where << " needs a mesh that is not periodic along this axis.");
      mesh::flattenLayers(mesh, {axis, *positions, settings.flat_height}, where);
    }
  }
}

constexpr char const* cell_size = "Cell Size";

template <class Settings>
void addCellSize(Entries<Settings>& entries, std::string const& meaning)
{
  entries.others().field(cell_size, optional, "m", Range::positive(), meaning).withoutDatasets();
  entries.real("Cell Size Factor", &CellSettings::size_factor, "-", Range::positive(),
               "This factor multiplies the cell size: 2 makes the whole mesh coarser.");
}

struct Rectangle : mesh::RectangleShape, CellSettings
{
};

Entries<Rectangle> rectangleEntries()
{
  using mesh::RectangleShape;
  Entries<Rectangle> entries;
  entries
    .real("Width", &RectangleShape::width, "m", Range::positive(),
          "The rectangle has this extent along x.")
    .real("Height", &RectangleShape::height, "m", Range::positive(),
          "The rectangle has this extent along y.")
    .integer("Cells X", &RectangleShape::cells_x, Range::atLeast(1),
             "The rectangle is divided into this number of columns, whose rectangles have two "
             "triangles each.")
    .integer("Cells Y", &RectangleShape::cells_y, Range::atLeast(1),
             "The rectangle is divided into this number of rows, whose rectangles have two "
             "triangles each.")
    .realArray("Lower Left", &RectangleShape::lower_left, "m", Range::any(),
               "The lower left corner of the rectangle lies at this position.");
  addCellSize(
    entries,
    "The longer side of rectangles is at most this function of x and y, which is evaluated "
    "at corners, centroid and midpoints of edges of the triangles. They are bisected until "
    "that is so, and keep the proportions of columns and rows. If columns and rows are 2^k "
    "times this size, the result has exactly this size. Without this entry no cell is "
    "bisected.");
  addFlatCells(entries, 2);
  return entries;
}

struct Box : mesh::BoxShape, CellSettings
{
  bool is_periodic = false;
};

Entries<Box> boxEntries()
{
  Entries<Box> entries;
  entries
    .realArray("Size", &Box::size, "m", Range::positive(),
               "The box has these extents along x, y and z.")
    .realArray("Lowest Corner", &Box::lowest_corner, "m", Range::any(),
               "The corner with the smallest x, y and z lies at this position.")
    .integer(
      "Cells X", [](Box & box) -> auto& { return box.num_cells[0]; }, Range::atLeast(1),
      "The box is divided into this number of cuboids along x, which have six tetrahedra each.")
    .integer(
      "Cells Y", [](Box & box) -> auto& { return box.num_cells[1]; }, Range::atLeast(1),
      "The box is divided into this number of cuboids along y.")
    .integer(
      "Cells Z", [](Box & box) -> auto& { return box.num_cells[2]; }, Range::atLeast(1),
      "The box is divided into this number of cuboids along z.");
  addCellSize(
    entries,
    "The longest side of cuboids is at most this function of x, y and z: tetrahedra are "
    "bisected until that is so, and keep the proportions of the first cuboids. If these are "
    "2^k times this size, the result has exactly this size. Without this entry no cell is "
    "bisected.");
  addFlatCells(entries, 3);
  return entries.boolean("Periodic Along z", &Box::is_periodic, periodic_meaning);
}

// The cell size of a list, times a factor, at a point of space.
template <int Dim>
std::function<double(Point<Dim> const&)> cellSize(ParameterList const& list,
                                                  std::string const& type, double factor)
{
  auto const size =
    std::make_shared<Field>(steadyField(list, cell_size, joinPath(mesh_path, type), {"body"}));
  return [size, factor](Point<Dim> const& x) { return factor * (*size)(inSpace<Dim>(x), 0, 0); };
}

GlobalMesh<2> makeRectangle(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto shape = rectangleEntries().read(list, joinPath(mesh_path, list.name()));
  shape.limit = limit;
  auto rectangle = mesh::rectangleMesh(shape);
  const Point<2> brick = {shape.width / shape.cells_x, shape.height / shape.cells_y};
  if (isGiven(list, cell_size)) {
    rectangle = mesh::bisectBricks<2>(rectangle, brick,
                                      cellSize<2>(list, "Rectangle", shape.size_factor), limit);
  }
  flattenCells(shape, "Rectangle", rectangle);
  return rectangle;
}

GlobalMesh<3> makeBox(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto shape = boxEntries().read(list, joinPath(mesh_path, list.name()));
  shape.limit = limit;
  auto box = mesh::boxMesh(shape);
  if (shape.is_periodic) {
    mesh::makePeriodic(box, 2, "front", "back"); // bisection keeps it so
  }
  Point<3> brick;
  for (int axis = 0; axis < 3; ++axis) {
    brick[axis] = shape.size[axis] / shape.num_cells[axis];
  }
  if (isGiven(list, cell_size)) {
    box = mesh::bisectBricks<3>(box, brick, cellSize<3>(list, "Box", shape.size_factor), limit);
  }
  flattenCells(shape, "Box", box);
  return box;
}
} // namespace

Generator<2> rectangleGenerator()
{
  Generator<2> rectangle;
  rectangle.name = "Rectangle";
  rectangle.entries = rectangleEntries().list();
  rectangle.sizes = "Cell Size, Cells X, Cells Y, Width, Height";
  rectangle.lower_cells = "The first cells of a Rectangle give all its cells their proportions.";
  rectangle.make = makeRectangle;
  return rectangle;
}

Generator<3> boxGenerator()
{
  Generator<3> box;
  box.name = "Box";
  box.entries = boxEntries().list();
  box.sizes = "Cell Size, Cells X, Cells Y, Cells Z, Size";
  box.lower_cells = "'Flat Cells at' makes them in a Box.";
  box.make = makeBox;
  return box;
}
} // namespace asperity::scenario
