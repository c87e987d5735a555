#include "scenario/setup/mesh/GeneratedMesh.hpp"

#include "base/Errors.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/FlatLayers.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"
#include "parameters/Entries.hpp"
#include "parameters/fields/Field.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace asperity::scenario
{
namespace
{
// The two ends of each of several intervals [m], one after the other.
using Ends = std::optional<std::vector<double>>;

constexpr char const* refined_intervals = "Refined Intervals";
constexpr char const* sizes_of_wedge =
  "Length, Height, Seismogenic Zone Width, Cell Size, Growth Factor";

struct Wedge : mesh::WedgeShape
{
  Ends refined; // along the base
};

Entries<Wedge> wedgeEntries()
{
  using mesh::WedgeShape;
  Entries<Wedge> entries;
  entries
    .real("Length", &WedgeShape::length, "m", Range::positive(),
          "The free surface has this length.")
    .real("Height", &WedgeShape::height, "m", Range::positive(),
          "The right face of the wedge has this height.")
    .real("Seismogenic Zone Width", &WedgeShape::zone_width, "m", Range::positive(),
          "The seismogenic zone has this width, measured along the base.")
    .real("Seismogenic Zone End", &WedgeShape::zone_end, "m", Range::positive(),
          "The seismogenic zone ends below the point of the surface that has this distance from "
          "the trench.")
    .real("Cell Size", &WedgeShape::cell_size, "m", Range::positive(),
          "No cell at the seismogenic zone has a larger diameter than this.")
    .real("Growth Factor", &WedgeShape::growth_factor, "-", Range::atLeast(0),
          "At one growth length from the seismogenic zone cells may be larger than at the zone by "
          "one plus this factor.")
    .real("Growth Length", &WedgeShape::growth_length, "m", Range::positive(),
          "Cells grow with the distance from the seismogenic zone, measured in this length; see "
          "'Growth Factor'.")
    .real("Viscous Thickness", &WedgeShape::viscous_thickness, "m", Range::atLeast(0),
          "The region 'lower' reaches from the deepest point vertically up to this height.");
  entries.realArray(
    refined_intervals, &Wedge::refined, optional, "m", Range::atLeast(0),
    "Cells are as small as at the seismogenic zone in these intervals of the base, too, "
    "for further patches that weaken; each is given by the distances of its two ends "
    "from the trench along the base, one interval after the other.");
  return entries;
}

constexpr char const* periodic_meaning =
  "If true, the body continues periodically along z: what leaves it through the back enters it at "
  "the front, and neither is a boundary.";

constexpr char const* seismogenic_intervals = "Seismogenic Intervals";

struct DeepWedge
{
  double depth = 0.1; // [m]
  bool is_graded = true;
  int num_layers = 10;
  Ends seismogenic; // along z
  bool is_periodic = false;
};

// They join those of the wedge.
Entries<DeepWedge> deepWedgeEntries(ParameterList& list)
{
  Entries<DeepWedge> entries({}, list);
  entries
    .real("Depth", &DeepWedge::depth, "m", Range::positive(),
          "The body reaches along z from 0 to this depth.")
    .choice("Cells", &DeepWedge::is_graded, {{"Graded", true}, {"Layers", false}},
            "Selects how the wedge is divided. Graded: cells grow away from the seismogenic zone "
            "in all three directions. Layers: the two-dimensional mesh is extruded along z.")
    .integer("Layers", &DeepWedge::num_layers, Range::atLeast(1),
             "With Cells = Layers the mesh has this number of layers.");
  entries.realArray(
    seismogenic_intervals, &DeepWedge::seismogenic, optional, "m", Range::any(),
    "With Cells = Graded the zone is seismogenic in these intervals of z; each is given "
    "by its two ends, one interval after the other. Without this entry it is "
    "seismogenic over the whole depth.");
  return entries.boolean("Periodic Along z", &DeepWedge::is_periodic, periodic_meaning);
}

RCP<const ParameterList> deepWedgeParameters()
{
  auto const list = wedgeEntries().list();
  deepWedgeEntries(*list);
  return list;
}

// None if no ends are given. path: of the entry.
std::vector<Point<2>> intervals(Ends const& ends, std::string const& path, std::string const& axis)
{
  if (!ends) {
    return {};
  }
  ASPERITY_REQUIRE(!ends->empty() && ends->size() % 2 == 0,
                   path << " needs pairs: where each interval begins and ends, along " << axis
                        << ".");
  std::vector<Point<2>> pairs;
  for (std::size_t i = 0; i < ends->size(); i += 2) {
    pairs.push_back({(*ends)[i], (*ends)[i + 1]});
  }
  return pairs;
}

mesh::WedgeShape wedgeShape(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto const path = joinPath(mesh_path, list.name());
  auto wedge = wedgeEntries().read(list, path);
  wedge.limit = limit;
  wedge.further_zones = intervals(wedge.refined, joinPath(path, refined_intervals), "the base");
  return wedge;
}

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

GlobalMesh<3> makeDeepWedge(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto const shape = wedgeShape(list, limit);
  ParameterList declared;
  auto const path = joinPath(mesh_path, list.name());
  auto const deep = deepWedgeEntries(declared).read(list, path);
  if (deep.is_graded) {
    auto const seismogenic =
      intervals(deep.seismogenic, joinPath(path, seismogenic_intervals), "z");
    return mesh::deepWedgeMesh(shape, {deep.depth, seismogenic, deep.is_periodic});
  }
  auto wedge = mesh::layeredWedgeMesh(shape, deep.depth, deep.num_layers);
  if (deep.is_periodic) {
    mesh::makePeriodic(wedge, 2, "front", "back");
  }
  return wedge;
}

// A type of mesh with what makes it. A row of generators() is all that a type needs: its dimension
// is that of the list in which it stands.
template <int Dim>
struct Generator : GeneratedMesh
{
  std::function<GlobalMesh<Dim>(ParameterList const&, mesh::VertexLimit const&)> make;
};

template <int Dim>
std::vector<Generator<Dim>> generators();

template <>
std::vector<Generator<2>> generators()
{
  Generator<2> wedge, rectangle;
  wedge.name = "Wedge";
  wedge.entries = wedgeEntries().list();
  wedge.sizes = sizes_of_wedge;
  wedge.is_wedge = true;
  wedge.make = [](ParameterList const& list, mesh::VertexLimit const& limit) {
    return mesh::wedgeMesh(wedgeShape(list, limit));
  };
  rectangle.name = "Rectangle";
  rectangle.entries = rectangleEntries().list();
  rectangle.sizes = "Cell Size, Cells X, Cells Y, Width, Height";
  rectangle.lower_cells = "The first cells of a Rectangle give all its cells their proportions.";
  rectangle.make = makeRectangle;
  return {wedge, rectangle};
}

template <>
std::vector<Generator<3>> generators()
{
  Generator<3> wedge, box;
  wedge.name = "Deep Wedge";
  wedge.entries = deepWedgeParameters();
  wedge.sizes = std::string(sizes_of_wedge) + ", Depth";
  wedge.is_wedge = true;
  wedge.make = makeDeepWedge;
  box.name = "Box";
  box.entries = boxEntries().list();
  box.sizes = "Cell Size, Cells X, Cells Y, Cells Z, Size";
  box.lower_cells = "'Flat Cells at' makes them in a Box.";
  box.make = makeBox;
  return {wedge, box};
}

// The limit of a mesh of the type, with the advice for a mesh that is too large.
mesh::VertexLimit vertexLimit(GeneratedMesh const& type, int most_vertices)
{
  return {static_cast<double>(most_vertices),
          "Is one of the entries of " + joinPath(mesh_path, type.name) +
            " missing, or not in m: " + type.sizes + "? A larger mesh is made where " +
            joinPath(mesh_path, "Most Vertices") + " allows it."};
}
} // namespace

std::vector<GeneratedMesh> generatedMeshes()
{
  std::vector<GeneratedMesh> types;
  const auto add = [&types](auto const& rows, int dimension) {
    for (GeneratedMesh type : rows) {
      type.dimension = dimension;
      types.push_back(type);
    }
  };
  add(generators<2>(), 2);
  add(generators<3>(), 3);
  return types;
}

std::optional<GeneratedMesh> generatedMesh(std::string const& type)
{
  auto const types = generatedMeshes();
  auto const found = std::find_if(types.begin(), types.end(),
                                  [&](GeneratedMesh const& each) { return each.name == type; });
  return found == types.end() ? std::nullopt : std::optional<GeneratedMesh>(*found);
}

template <int Dim>
GlobalMesh<Dim> generateMesh(ParameterList const& list, std::string const& type, int most_vertices)
{
  auto const rows = generators<Dim>();
  auto const chosen =
    std::find_if(rows.begin(), rows.end(), [&](auto const& row) { return row.name == type; });
  ASPERITY_ASSERT(chosen != rows.end());
  return chosen->make(list, vertexLimit(*chosen, most_vertices));
}

template GlobalMesh<2> generateMesh(ParameterList const&, std::string const&, int);
template GlobalMesh<3> generateMesh(ParameterList const&, std::string const&, int);
} // namespace asperity::scenario
