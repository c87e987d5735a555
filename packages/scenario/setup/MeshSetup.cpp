#include "scenario/setup/MeshSetup.hpp"

#include "base/fields/Field.hpp"
#include "base/program/WorkTimers.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/Regions.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/DeepWedgeMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"
#include "mesh/parallel/Partition.hpp"
#include "refinement/UniformRefinement.hpp"
#include "scenario/setup/NodalField.hpp"

#include <memory>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Mesh";

Declare wedgeParameters()
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
  return wedgeParameters()
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
  auto const ends = list.get<Teuchos::Array<double>>(name);
  ASPERITY_REQUIRE(ends.size() > 0 && ends.size() % 2 == 0,
                   joinPath(joinPath(path, list.name()), name)
                     << " needs pairs: where each interval begins and ends, along " << axis << ".");
  std::vector<Point<2>> pairs;
  for (int i = 0; i < ends.size(); i += 2) {
    pairs.push_back({ends[i], ends[i + 1]});
  }
  return pairs;
}

// Of the list "Mesh": what is said where an extent or a size is forgotten.
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
          "Is one of the entries of " + joinPath(path, type) + " missing, or not in m: " + names +
            "? A larger mesh is made where " + joinPath(path, "Most Vertices") + " allows it."};
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

RCP<const ParameterList> rectangleParameters()
{
  return Declare()
    .real("Width", 1., "m", Range::positive(), "The rectangle has this extent along x.")
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
           "at corners, centroid and midpoints of edges of the triangles: they are bisected until "
           "that is so, and keep the proportions of columns and rows. From 2^k times this size "
           "follows exactly this size. Without this entry no cell is bisected.")
    .real("Cell Size Factor", 1., "-", Range::positive(),
          "This factor multiplies the cell size: 2 makes the whole mesh coarser.")
    .list();
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
                   path << " / Rectangle / Lower Left needs two numbers, x and y.");
  shape.lower_left = {corner[0], corner[1]};
  return shape;
}

RCP<const ParameterList> boxParameters()
{
  return Declare()
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
           "bisected until that is so, and keep the proportions of the first cuboids. From 2^k "
           "times this size follows exactly this size. Without this entry no cell is bisected.")
    .real("Cell Size Factor", 1., "-", Range::positive(),
          "This factor multiplies the cell size: 2 makes the whole mesh coarser.")
    .boolean("Periodic Along z", false, periodic_meaning)
    .list();
}

Point<3> threeNumbers(ParameterList const& list, std::string const& name)
{
  auto const given = list.get<Teuchos::Array<double>>(name);
  ASPERITY_REQUIRE(given.size() == 3, path << " / Box / " << name << " needs three numbers.");
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

void refuseTime(Field const& field)
{
  ASPERITY_REQUIRE(!field.dependsOnTime(), field.path() << " depends on t. Remove t from it.");
}

// The cell size of a list, at a point of space.
template <int Dim>
std::function<double(Point<Dim> const&)> cellSize(ParameterList const& list,
                                                  std::string const& type)
{
  auto const size = std::make_shared<Field>(list, "Cell Size", joinPath(path, type),
                                            std::vector<std::string>{"body"});
  refuseTime(*size);
  const double factor = list.get<double>("Cell Size Factor");
  return [size, factor](Point<Dim> const& x) { return factor * (*size)(inSpace<Dim>(x), 0, 0); };
}

GlobalMesh<2> makeRectangle(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto const shape = rectangleShape(list, limit);
  auto coarse = mesh::rectangleMesh(shape);
  const Point<2> brick = {shape.width / shape.cells_x, shape.height / shape.cells_y};
  return isGiven(list, "Cell Size")
           ? mesh::bisectBricks(coarse, brick, cellSize<2>(list, "Rectangle"), limit)
           : coarse;
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
  return isGiven(list, "Cell Size")
           ? mesh::bisectBricks(box, brick, cellSize<3>(list, "Box"), limit)
           : box;
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

template <int Dim>
GlobalMesh<Dim> generate(std::string const& type, ParameterList const& list,
                         mesh::VertexLimit const& limit)
{
  if constexpr (Dim == 2) {
    return type == "Wedge" ? mesh::wedgeMesh(wedgeShape(list, limit)) : makeRectangle(list, limit);
  } else {
    return type == "Box" ? makeBox(list, limit) : makeDeepWedge(list, limit);
  }
}

// The entries of the list `name`, one condition each.
template <int Dim>
std::vector<mesh::NamedCondition<Dim>> conditionsIn(ParameterList const& mesh,
                                                    std::string const& name)
{
  auto const& list = mesh.sublist(name);
  std::vector<mesh::NamedCondition<Dim>> conditions;
  for (auto const& entry : list) {
    auto const condition =
      std::make_shared<Field>(list, entry.first, joinPath(path, name), std::vector<std::string>{});
    refuseTime(*condition);
    conditions.push_back({entry.first, [condition](Point<Dim> const& x) {
                            return (*condition)(inSpace<Dim>(x), 0, 0) != 0;
                          }});
  }
  return conditions;
}
// This rank's part of the mesh before it is refined.
template <int Dim>
Mesh<Dim> coarsePart(ParameterList const& list, std::string const& fault,
                     RCP<const Communicator> const& communicator)
{
  auto const type = list.get<std::string>("Type");
  auto const& of_type = list.sublist(type);
  auto const regions = conditionsIn<Dim>(list, "Regions");
  auto const boundaries = conditionsIn<Dim>(list, "Boundaries");
  auto const where_regions = joinPath(path, "Regions");
  auto const where_boundaries = joinPath(path, "Boundaries");
  auto const faults = conditionsIn<Dim>(list, "Faults");
  auto const where_faults = joinPath(path, "Faults");
  auto const file_name = type == "File" ? of_type.get<std::string>("File Name") : std::string();
  if (type == "File" && mesh::isPartitioned(file_name, *communicator)) {
    ASPERITY_REQUIRE(faults.empty(),
                     where_faults << " / " << faults.front().name << ": mesh file '" << file_name
                                  << "' is partitioned, and was split along its faults before. "
                                  << "Put the fault into the mesh and then partition that.");
    auto part = mesh::readPart<Dim>(file_name, communicator);
    mesh::overrideRegions(part, regions, *communicator, where_regions);
    mesh::overrideBoundaries(part, boundaries, *communicator, where_boundaries);
    return part;
  }
  auto whole = type == "File" ? mesh::readMesh<Dim>(file_name, *communicator)
                              : generate<Dim>(type, of_type, vertexLimit(list));
  mesh::overrideRegions(whole, regions, where_regions);
  mesh::overrideBoundaries(whole, boundaries, where_boundaries);
  mesh::addFaults(whole, faults, where_faults);
  if (type == "File" || !faults.empty()) { // generators make none
    mesh::splitFaults(whole, path);
  }
  mesh::PartitionOptions options;
  options.boundary = whole.boundaries.count(fault) > 0 ? fault : "";
  options.by_cells = list.get<int>("Refinements") > 0;
  return mesh::distribute(whole, *communicator, options);
}
} // namespace

RCP<const ParameterList> meshParameters()
{
  return Declare()
    .choiceOfLists(
      "Type", "Wedge",
      {{"Wedge", wedgeParameters().list()},
       {"Rectangle", rectangleParameters()},
       {"Deep Wedge", deepWedgeParameters()},
       {"Box", boxParameters()},
       {"File", Declare()
                  .fileName("File Name", required,
                            "The mesh is read from this HDF5 file, as asperity-mesh writes it, in "
                            "two or three dimensions. A file that asperity-mesh has partitioned "
                            "must have as many parts as there are ranks. A relative name is looked "
                            "for beside the deck, and then from where the program was started.")
                  .list()}},
      "Selects the shape of the body. In two dimensions it is the analogue wedge (thesis A.1) or a "
      "rectangle; in three dimensions the wedge with a depth along z or a box; in both a mesh from "
      "a file.")
    .integer("Most Vertices", 500000, Range::atLeast(3),
             "A mesh that is made here, and not read from a file, has at most this number of "
             "vertices, before 'Refinements'; a larger one is refused before it is made. A "
             "forgotten extent or cell size is found so.")
    .integer("Refinements", 0, Range::atLeast(0),
             "Every cell is divided this number of times, triangles into 4 and tetrahedra into 8, "
             "on all ranks at once, with its region, boundaries and faults. The body keeps the "
             "shape of the coarse mesh, for which the conditions in 'Regions', 'Boundaries' and "
             "'Faults' are evaluated.")
    .openSublist(
      "Regions",
      Declare()
        .field("<region>", required, "-", Range::any(),
               "A cell belongs to the region if this condition, evaluated at its centroid, is not "
               "zero. If several regions claim a cell, the last one gets it.")
        .list(),
      "Each entry defines a region by a condition. It takes its cells from the regions of the "
      "mesh.")
    .openSublist(
      "Boundaries",
      Declare()
        .field(
          "<boundary>", required, "-", Range::any(),
          "A facet of the outer boundary belongs to this boundary if the condition, evaluated at "
          "its centre, is not zero. If several boundaries claim a facet, the last one gets it.")
        .list(),
      "Each entry defines a boundary by a condition. It takes its facets from the boundaries of "
      "the mesh.")
    .openSublist(
      "Faults",
      Declare()
        .field("<fault>", required, "-", Range::any(),
               "A facet between two cells belongs to this fault if the condition, evaluated at its "
               "vertices and at its centre, is nowhere zero. If several faults claim a facet, the "
               "last one gets it.")
        .list(),
      "Each entry defines a fault inside the body by a condition, as abs(y) < 1e-6. The edges of "
      "the cells must lie along it: the mesh is split there, and is not moved.")
    .list();
}

int meshDimension(ParameterList const& list, Communicator const& communicator)
{
  auto const type = list.get<std::string>("Type");
  if (type == "File") {
    return mesh::fileDimension(list.sublist(type).get<std::string>("File Name"), communicator);
  }
  return type == "Box" || type == "Deep Wedge" ? 3 : 2;
}

template <int Dim>
Mesh<Dim> makeMesh(ParameterList const& list, std::string const& fault,
                   RCP<const Communicator> const& communicator)
{
  ASPERITY_TIME_WORK("mesh");
  return refinement::refineUniformly(coarsePart<Dim>(list, fault, communicator),
                                     list.get<int>("Refinements"), *communicator,
                                     joinPath(path, "Refinements"));
}

template Mesh<2> makeMesh(ParameterList const&, std::string const&, RCP<const Communicator> const&);
template Mesh<3> makeMesh(ParameterList const&, std::string const&, RCP<const Communicator> const&);
} // namespace asperity::scenario
