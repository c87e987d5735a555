#include "scenario/MeshSetup.hpp"

#include "base/Field.hpp"
#include "mesh/Bisection.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/MeshFile.hpp"
#include "mesh/Partition.hpp"
#include "mesh/RectangleMesh.hpp"
#include "mesh/Regions.hpp"
#include "mesh/WedgeMesh.hpp"
#include "scenario/NodalField.hpp"

#include <memory>

namespace asperity::scenario
{
namespace
{
const std::string path = "Asperity / Mesh";

RCP<const ParameterList> wedgeParameters()
{
  const mesh::WedgeShape defaults;
  return Declare()
    .real("Length", defaults.length, "m", Range::positive(), "Length of the surface.")
    .real("Height", defaults.height, "m", Range::positive(), "Height of the right face.")
    .real("Seismogenic Zone Width", defaults.zone_width, "m", Range::positive(),
          "Width of the seismogenic zone, measured along the base.")
    .real("Seismogenic Zone End", defaults.zone_end, "m", Range::positive(),
          "Where the zone ends, measured along the surface from the trench.")
    .real("Cell Size", defaults.cell_size, "m", Range::positive(),
          "Largest diameter of a cell at the seismogenic zone.")
    .real("Growth Factor", defaults.growth_factor, "-", Range::atLeast(0),
          "Cells may be larger by this factor, plus one, at one growth length from the zone.")
    .real("Growth Length", defaults.growth_length, "m", Range::positive(),
          "Length over which cells grow.")
    .real("Viscous Thickness", defaults.viscous_thickness, "m", Range::atLeast(0),
          "Thickness of the region 'lower', measured vertically from the deepest point.")
    .list();
}

mesh::WedgeShape wedgeShape(ParameterList const& list)
{
  mesh::WedgeShape shape;
  shape.length = list.get<double>("Length");
  shape.height = list.get<double>("Height");
  shape.zone_width = list.get<double>("Seismogenic Zone Width");
  shape.zone_end = list.get<double>("Seismogenic Zone End");
  shape.cell_size = list.get<double>("Cell Size");
  shape.growth_factor = list.get<double>("Growth Factor");
  shape.growth_length = list.get<double>("Growth Length");
  shape.viscous_thickness = list.get<double>("Viscous Thickness");
  return shape;
}

RCP<const ParameterList> rectangleParameters()
{
  return Declare()
    .real("Width", 1., "m", Range::positive(), "Extent along x.")
    .real("Height", 1., "m", Range::positive(), "Extent along y.")
    .integer("Cells X", 1, Range::atLeast(1), "Columns of two triangles each.")
    .integer("Cells Y", 1, Range::atLeast(1), "Rows of two triangles each.")
    .realArray("Lower Left", std::vector<double>{0., 0.}, "m", Range::any(),
               "Position of the lower left corner.")
    .field("Cell Size", optional, "m", Range::positive(),
           "Cells are bisected until their longest edge is at most sqrt(2) times this, a function "
           "of x and y, at corners, centroid and midpoints of edges. With square cells of 2^k "
           "times this, what lies on a side has edges of exactly this length. Left out, cells stay "
           "as they are.")
    .real("Cell Size Factor", 1., "-", Range::positive(),
          "Multiplies the cell size: 2 makes the whole mesh coarser.")
    .list();
}

mesh::RectangleShape rectangleShape(ParameterList const& list)
{
  mesh::RectangleShape shape;
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

void refuseTime(Field const& field)
{
  ASPERITY_REQUIRE(!field.dependsOnTime(), field.path() << " depends on t. Remove t from it.");
}

GlobalMesh<2> makeRectangle(ParameterList const& list)
{
  auto const coarse = mesh::rectangleMesh(rectangleShape(list));
  if (!isGiven(list, "Cell Size")) {
    return coarse;
  }
  const Field size(list, "Cell Size", joinPath(path, "Rectangle"), coarse.region_names);
  refuseTime(size);
  const double factor = list.get<double>("Cell Size Factor");
  return mesh::bisect(coarse, mesh::largestDiameter([&](Point<2> const& x) {
                        return factor * size({x[0], x[1], 0}, 0, 0);
                      }));
}

// The entries of the list `name`, one condition each.
std::vector<mesh::NamedCondition<2>> conditionsIn(ParameterList const& mesh,
                                                  std::string const& name)
{
  auto const& list = mesh.sublist(name);
  std::vector<mesh::NamedCondition<2>> conditions;
  for (auto const& entry : list) {
    auto const condition =
      std::make_shared<Field>(list, entry.first, joinPath(path, name), std::vector<std::string>{});
    refuseTime(*condition);
    conditions.push_back({entry.first, [condition](Point<2> const& x) {
                            return (*condition)({x[0], x[1], 0}, 0, 0) != 0;
                          }});
  }
  return conditions;
}
} // namespace

RCP<const ParameterList> meshParameters()
{
  return Declare()
    .choiceOfLists(
      "Type", "Wedge",
      {{"Wedge", wedgeParameters()},
       {"Rectangle", rectangleParameters()},
       {"File", Declare()
                  .fileName("File Name", required, "Mesh in HDF5 as asperity-mesh writes it.")
                  .list()}},
      "The analogue wedge (thesis A.1), a rectangle, or a file.")
    .openSublist(
      "Regions",
      Declare()
        .field(
          "<region>", required, "-", Range::any(),
          "Condition in x and y of a cell's centroid; where it is not zero the cell belongs to "
          "the region, the last one winning.")
        .list(),
      "Regions by condition, besides or instead of those of the mesh.")
    .openSublist(
      "Boundaries",
      Declare()
        .field("<boundary>", required, "-", Range::any(),
               "Condition in x and y of a facet's centre; where it is not zero the facet, one of "
               "the outer boundary, belongs to this boundary, the last one winning.")
        .list(),
      "Pieces of the boundary by condition, besides or instead of those of the mesh.")
    .list();
}

Mesh<2> makeMesh(ParameterList const& list, RCP<const Communicator> const& communicator)
{
  auto const type = list.get<std::string>("Type");
  auto const& of_type = list.sublist(type);
  auto whole = type == "Wedge" ? mesh::wedgeMesh(wedgeShape(of_type))
               : type == "Rectangle"
                 ? makeRectangle(of_type)
                 : mesh::readMesh<2>(of_type.get<std::string>("File Name"), *communicator);
  mesh::overrideRegions(whole, conditionsIn(list, "Regions"), joinPath(path, "Regions"));
  mesh::overrideBoundaries(whole, conditionsIn(list, "Boundaries"), joinPath(path, "Boundaries"));
  return mesh::distribute(whole, *communicator);
}
} // namespace asperity::scenario
