#include "scenario/setup/mesh/GeneratedMesh.hpp"

#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/FlatLayers.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"
#include "parameters/fields/Field.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"

#include <memory>

namespace asperity::scenario
{
namespace
{
Declare wedgeEntries()
{
  const mesh::WedgeShape defaults;
  Declare declare;
  declare
    .real("Length", defaults.length, "m", Range::positive(), "The free surface has this length.")
    .real("Height", defaults.height, "m", Range::positive(),
          "The right face of the wedge has this height.")
    .real("Seismogenic Zone Width", defaults.zone_width, "m", Range::positive(),
          "The seismogenic zone has this width, measured along the base.")
    .real("Seismogenic Zone End", defaults.zone_end, "m", Range::positive(),
          "The seismogenic zone ends below the point of the surface that has this distance from "
          "the trench.")
    .real("Cell Size", defaults.cell_size, "m", Range::positive(),
          "No cell at the seismogenic zone has a larger diameter than this.")
    .real("Growth Factor", defaults.growth_factor, "-", Range::atLeast(0),
          "At one growth length from the seismogenic zone cells may be larger than at the zone by "
          "one plus this factor.")
    .real("Growth Length", defaults.growth_length, "m", Range::positive(),
          "Cells grow with the distance from the seismogenic zone, measured in this length; see "
          "'Growth Factor'.")
    .real("Viscous Thickness", defaults.viscous_thickness, "m", Range::atLeast(0),
          "The region 'lower' reaches from the deepest point vertically up to this height.")
    .realArray("Refined Intervals", optional, "m", Range::atLeast(0),
               "Cells are as small as at the seismogenic zone in these intervals of the base, too, "
               "for further patches that weaken; each is given by the distances of its two ends "
               "from the trench along the base, one interval after the other.");
  return declare;
}

constexpr char const* periodic_meaning =
  "If true, the body continues periodically along z: what leaves it through the back enters it at "
  "the front, and neither is a boundary.";

RCP<const ParameterList> deepWedgeParameters()
{
  return wedgeEntries()
    .real("Depth", 0.1, "m", Range::positive(), "The body reaches along z from 0 to this depth.")
    .choice("Cells", "Graded", {"Graded", "Layers"},
            "Selects how the wedge is divided. Graded: cells grow away from the seismogenic zone "
            "in all three directions. Layers: the two-dimensional mesh is extruded along z.")
    .integer("Layers", 10, Range::atLeast(1),
             "With Cells = Layers the mesh has this number of layers.")
    .realArray("Seismogenic Intervals", optional, "m", Range::any(),
               "With Cells = Graded the zone is seismogenic in these intervals of z; each is given "
               "by its two ends, one interval after the other. Without this entry it is "
               "seismogenic over the whole depth.")
    .boolean("Periodic Along z", false, periodic_meaning)
    .list();
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
  mesh::WedgeShape shape;
  shape.limit = limit;
  shape.length = list.get<double>("Length");
  shape.height = list.get<double>("Height");
  shape.zone_width = list.get<double>("Seismogenic Zone Width");
  shape.zone_end = list.get<double>("Seismogenic Zone End");
  shape.cell_size = list.get<double>("Cell Size");
  shape.growth_factor = list.get<double>("Growth Factor");
  shape.growth_length = list.get<double>("Growth Length");
  shape.viscous_thickness = list.get<double>("Viscous Thickness");
  shape.further_zones = intervals(list, "Refined Intervals", "the base");
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

RCP<const ParameterList> rectangleParameters()
{
  Declare declare;
  declare.real("Width", 1., "m", Range::positive(), "The rectangle has this extent along x.")
    .real("Height", 1., "m", Range::positive(), "The rectangle has this extent along y.")
    .integer("Cells X", 1, Range::atLeast(1),
             "The rectangle is divided into this number of columns, whose rectangles have two "
             "triangles each.")
    .integer("Cells Y", 1, Range::atLeast(1),
             "The rectangle is divided into this number of rows, whose rectangles have two "
             "triangles each.")
    .realArray("Lower Left", std::vector<double>{0., 0.}, "m", Range::any(),
               "The lower left corner of the rectangle lies at this position.")
    .field("Cell Size", optional, "m", Range::positive(),
           "The longer side of rectangles is at most this function of x and y, which is evaluated "
           "at corners, centroid and midpoints of edges of the triangles. They are bisected until "
           "that is so, and keep the proportions of columns and rows. If columns and rows are 2^k "
           "times this size, the result has exactly this size. Without this entry no cell is "
           "bisected.")
    .withoutDatasets()
    .real("Cell Size Factor", 1., "-", Range::positive(),
          "This factor multiplies the cell size: 2 makes the whole mesh coarser.");
  return declareFlatCells(declare, 2).list();
}

mesh::RectangleShape rectangleShape(ParameterList const& list, mesh::VertexLimit const& limit)
{
  mesh::RectangleShape shape;
  shape.limit = limit;
  shape.width = list.get<double>("Width");
  shape.height = list.get<double>("Height");
  shape.cells_x = list.get<int>("Cells X");
  shape.cells_y = list.get<int>("Cells Y");
  auto const corner = list.get<Teuchos::Array<double>>("Lower Left");
  ASPERITY_REQUIRE(corner.size() == 2,
                   mesh_path << " / Rectangle / Lower Left needs two numbers, x and y.");
  shape.lower_left = {corner[0], corner[1]};
  return shape;
}

RCP<const ParameterList> boxParameters()
{
  Declare declare;
  declare
    .realArray("Size", std::vector<double>{1., 1., 1.}, "m", Range::positive(),
               "The box has these extents along x, y and z.")
    .realArray("Lowest Corner", std::vector<double>{0., 0., 0.}, "m", Range::any(),
               "The corner with the smallest x, y and z lies at this position.")
    .integer(
      "Cells X", 1, Range::atLeast(1),
      "The box is divided into this number of cuboids along x, which have six tetrahedra each.")
    .integer("Cells Y", 1, Range::atLeast(1),
             "The box is divided into this number of cuboids along y.")
    .integer("Cells Z", 1, Range::atLeast(1),
             "The box is divided into this number of cuboids along z.")
    .field("Cell Size", optional, "m", Range::positive(),
           "The longest side of cuboids is at most this function of x, y and z: tetrahedra are "
           "bisected until that is so, and keep the proportions of the first cuboids. If these are "
           "2^k times this size, the result has exactly this size. Without this entry no cell is "
           "bisected.")
    .withoutDatasets()
    .real("Cell Size Factor", 1., "-", Range::positive(),
          "This factor multiplies the cell size: 2 makes the whole mesh coarser.");
  return declareFlatCells(declare, 3).boolean("Periodic Along z", false, periodic_meaning).list();
}

Point<3> threeNumbers(ParameterList const& list, std::string const& name)
{
  auto const& given = list.get<Teuchos::Array<double>>(name);
  ASPERITY_REQUIRE(given.size() == 3, mesh_path << " / Box / " << name << " needs three numbers.");
  return {given[0], given[1], given[2]};
}

mesh::BoxShape boxShape(ParameterList const& list, mesh::VertexLimit const& limit)
{
  mesh::BoxShape shape;
  shape.limit = limit;
  shape.size = threeNumbers(list, "Size");
  shape.lowest_corner = threeNumbers(list, "Lowest Corner");
  shape.num_cells = {list.get<int>("Cells X"), list.get<int>("Cells Y"), list.get<int>("Cells Z")};
  return shape;
}

// The cell size of a list, at a point of space.
template <int Dim>
std::function<double(Point<Dim> const&)> cellSize(ParameterList const& list,
                                                  std::string const& type)
{
  auto const size =
    std::make_shared<Field>(steadyField(list, "Cell Size", joinPath(mesh_path, type), {"body"}));
  const double factor = list.get<double>("Cell Size Factor");
  return [size, factor](Point<Dim> const& x) { return factor * (*size)(inSpace<Dim>(x), 0, 0); };
}

GlobalMesh<2> makeRectangle(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto const shape = rectangleShape(list, limit);
  auto rectangle = mesh::rectangleMesh(shape);
  const Point<2> brick = {shape.width / shape.cells_x, shape.height / shape.cells_y};
  if (isGiven(list, "Cell Size")) {
    rectangle = mesh::bisectBricks<2>(rectangle, brick, cellSize<2>(list, "Rectangle"), limit);
  }
  flattenCells(list, "Rectangle", rectangle);
  return rectangle;
}

GlobalMesh<3> makeBox(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto const shape = boxShape(list, limit);
  auto box = mesh::boxMesh(shape);
  if (list.get<bool>("Periodic Along z")) {
    mesh::makePeriodic(box, 2, "front", "back"); // bisection keeps it so
  }
  Point<3> brick;
  for (int axis = 0; axis < 3; ++axis) {
    brick[axis] = shape.size[axis] / shape.num_cells[axis];
  }
  if (isGiven(list, "Cell Size")) {
    box = mesh::bisectBricks<3>(box, brick, cellSize<3>(list, "Box"), limit);
  }
  flattenCells(list, "Box", box);
  return box;
}

GlobalMesh<3> makeDeepWedge(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto const shape = wedgeShape(list, limit);
  const double depth = list.get<double>("Depth");
  const bool is_periodic = list.get<bool>("Periodic Along z");
  if (list.get<std::string>("Cells") == "Graded") {
    return mesh::deepWedgeMesh(shape,
                               {depth, intervals(list, "Seismogenic Intervals", "z"), is_periodic});
  }
  auto wedge = mesh::layeredWedgeMesh(shape, depth, list.get<int>("Layers"));
  if (is_periodic) {
    mesh::makePeriodic(wedge, 2, "front", "back");
  }
  return wedge;
}

} // namespace

std::vector<Declare::NamedList> generatedMeshParameters()
{
  return {{"Wedge", wedgeEntries().list()},
          {"Rectangle", rectangleParameters()},
          {"Deep Wedge", deepWedgeParameters()},
          {"Box", boxParameters()}};
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
