#include "scenario/setup/mesh/GeneratedMesh.hpp"

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

#include <memory>

namespace asperity::scenario
{
namespace
{
constexpr char const* refined_intervals = "Refined Intervals";

Entries<mesh::WedgeShape> wedgeEntries()
{
  using mesh::WedgeShape;
  Entries<WedgeShape> entries;
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
  entries.others().realArray(
    refined_intervals, optional, "m", Range::atLeast(0),
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
  entries.others().realArray(
    seismogenic_intervals, optional, "m", Range::any(),
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

// The pairs of numbers that an array of the wedge's list holds; none if it is not given.
std::vector<Point<2>> intervals(ParameterList const& list, std::string const& name,
                                std::string const& axis)
{
  if (!isGiven(list, name)) {
    return {};
  }
  auto const& ends = list.get<Teuchos::Array<double>>(name);
  ASPERITY_REQUIRE(!ends.empty() && ends.size() % 2 == 0,
                   joinPath(joinPath(mesh_path, list.name()), name)
                     << " needs pairs: where each interval begins and ends, along " << axis << ".");
  std::vector<Point<2>> pairs;
  for (int i = 0; i < ends.size(); i += 2) {
    pairs.push_back({ends[i], ends[i + 1]});
  }
  return pairs;
}

// The limit of the list `Mesh`, with the advice for a mesh that is too large.
mesh::VertexLimit vertexLimit(ParameterList const& list)
{
  auto const type = list.get<std::string>("Type");
  const bool is_wedge = type == "Wedge" || type == "Deep Wedge";
  std::string names = is_wedge ? "Length, Height, Seismogenic Zone Width, Cell Size, Growth Factor"
                               : "Cell Size, Cells X, Cells Y";
  names += type == "Deep Wedge"  ? ", Depth"
           : type == "Rectangle" ? ", Width, Height"
           : type == "Box"       ? ", Cells Z, Size"
                                 : "";
  return {static_cast<double>(list.get<int>("Most Vertices")),
          "Is one of the entries of " + joinPath(mesh_path, type) +
            " missing, or not in m: " + names + "? A larger mesh is made where " +
            joinPath(mesh_path, "Most Vertices") + " allows it."};
}

mesh::WedgeShape wedgeShape(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto shape = wedgeEntries().read(list, joinPath(mesh_path, list.name()));
  shape.limit = limit;
  shape.further_zones = intervals(list, refined_intervals, "the base");
  return shape;
}

std::string flatCellsAt(int axis) { return std::string("Flat Cells at ") + "xyz"[axis]; }

Declare& declareFlatCells(Declare& declare, int dimension)
{
  for (int axis = 0; axis < dimension; ++axis) {
    declare.realArray(flatCellsAt(axis), optional, "m", Range::any(),
                      std::string("Cells beside the planes at these ") + "xyz"[axis] +
                        " are flat, as faults want them; see 'Flat Cell Height'.");
  }
  return declare.real(
    "Flat Cell Height", 0.3, "-", Range::openClosed(0, 1),
    "Layers of cells beside the planes of 'Flat Cells at' are this times as high as without that "
    "entry, the next layers 1.5 times as much each, until they reach their own height. 'Cell Size' "
    "sees the positions before.");
}

// list: of a mesh of this type
template <int Dim>
void flattenCells(ParameterList const& list, std::string const& type, GlobalMesh<Dim>& mesh)
{
  for (int axis = 0; axis < Dim; ++axis) {
    auto const name = flatCellsAt(axis);
    if (isGiven(list, name)) {
      auto const where = joinPath(joinPath(mesh_path, type), name);
      ASPERITY_REQUIRE(mesh.period[axis] == 0,
                       where << " needs a mesh that is not periodic along this axis.");
      mesh::flattenLayers(mesh,
                          {axis, list.get<Teuchos::Array<double>>(name).toVector(),
                           list.get<double>("Flat Cell Height")},
                          where);
    }
  }
}

constexpr char const* cell_size = "Cell Size";
constexpr char const* cell_size_factor = "Cell Size Factor";

void declareCellSize(Declare& declare, std::string const& meaning)
{
  declare.field(cell_size, optional, "m", Range::positive(), meaning)
    .withoutDatasets()
    .real(cell_size_factor, 1., "-", Range::positive(),
          "This factor multiplies the cell size: 2 makes the whole mesh coarser.");
}

Entries<mesh::RectangleShape> rectangleEntries()
{
  using mesh::RectangleShape;
  Entries<RectangleShape> entries;
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
  declareCellSize(
    entries.others(),
    "The longer side of rectangles is at most this function of x and y, which is evaluated "
    "at corners, centroid and midpoints of edges of the triangles. They are bisected until "
    "that is so, and keep the proportions of columns and rows. If columns and rows are 2^k "
    "times this size, the result has exactly this size. Without this entry no cell is "
    "bisected.");
  declareFlatCells(entries.others(), 2);
  return entries;
}

struct Box : mesh::BoxShape
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
  declareCellSize(
    entries.others(),
    "The longest side of cuboids is at most this function of x, y and z: tetrahedra are "
    "bisected until that is so, and keep the proportions of the first cuboids. If these are "
    "2^k times this size, the result has exactly this size. Without this entry no cell is "
    "bisected.");
  declareFlatCells(entries.others(), 3);
  return entries.boolean("Periodic Along z", &Box::is_periodic, periodic_meaning);
}

// The cell size of a list, at a point of space.
template <int Dim>
std::function<double(Point<Dim> const&)> cellSize(ParameterList const& list,
                                                  std::string const& type)
{
  auto const size =
    std::make_shared<Field>(steadyField(list, cell_size, joinPath(mesh_path, type), {"body"}));
  const double factor = list.get<double>(cell_size_factor);
  return [size, factor](Point<Dim> const& x) { return factor * (*size)(inSpace<Dim>(x), 0, 0); };
}

GlobalMesh<2> makeRectangle(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto shape = rectangleEntries().read(list, joinPath(mesh_path, list.name()));
  shape.limit = limit;
  auto rectangle = mesh::rectangleMesh(shape);
  const Point<2> brick = {shape.width / shape.cells_x, shape.height / shape.cells_y};
  if (isGiven(list, cell_size)) {
    rectangle = mesh::bisectBricks<2>(rectangle, brick, cellSize<2>(list, "Rectangle"), limit);
  }
  flattenCells(list, "Rectangle", rectangle);
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
    box = mesh::bisectBricks<3>(box, brick, cellSize<3>(list, "Box"), limit);
  }
  flattenCells(list, "Box", box);
  return box;
}

GlobalMesh<3> makeDeepWedge(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto const shape = wedgeShape(list, limit);
  ParameterList declared;
  auto const deep = deepWedgeEntries(declared).read(list, joinPath(mesh_path, list.name()));
  if (deep.is_graded) {
    return mesh::deepWedgeMesh(
      shape, {deep.depth, intervals(list, seismogenic_intervals, "z"), deep.is_periodic});
  }
  auto wedge = mesh::layeredWedgeMesh(shape, deep.depth, deep.num_layers);
  if (deep.is_periodic) {
    mesh::makePeriodic(wedge, 2, "front", "back");
  }
  return wedge;
}

} // namespace

std::vector<Declare::NamedList> generatedMeshParameters()
{
  return {{"Wedge", wedgeEntries().list()},
          {"Rectangle", rectangleEntries().list()},
          {"Deep Wedge", deepWedgeParameters()},
          {"Box", boxEntries().list()}};
}

template <int Dim>
GlobalMesh<Dim> generateMesh(ParameterList const& mesh)
{
  auto const type = mesh.get<std::string>("Type");
  auto const& list = mesh.sublist(type);
  auto const limit = vertexLimit(mesh);
  if constexpr (Dim == 2) {
    return type == "Wedge" ? mesh::wedgeMesh(wedgeShape(list, limit)) : makeRectangle(list, limit);
  } else {
    return type == "Box" ? makeBox(list, limit) : makeDeepWedge(list, limit);
  }
}

template GlobalMesh<2> generateMesh(ParameterList const&);
template GlobalMesh<3> generateMesh(ParameterList const&);
} // namespace asperity::scenario
