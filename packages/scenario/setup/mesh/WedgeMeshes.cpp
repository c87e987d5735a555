#include "scenario/setup/mesh/Generators.hpp"

#include "base/Errors.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"

#include <optional>
#include <string>
#include <vector>

// The types Wedge and Deep Wedge.
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

mesh::WedgeShape wedgeShape(ParameterList const& list)
{
  auto const path = joinPath(mesh_path, list.name());
  auto wedge = wedgeEntries().read(list, path);
  wedge.further_zones = intervals(wedge.refined, joinPath(path, refined_intervals), "the base");
  return wedge;
}

GlobalMesh<3> makeDeepWedge(ParameterList const& list, mesh::VertexLimit const& limit)
{
  auto shape = wedgeShape(list);
  shape.limit = limit;
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
} // namespace

Generator<2> wedgeGenerator()
{
  Generator<2> wedge;
  wedge.name = "Wedge";
  wedge.entries = wedgeEntries().list();
  wedge.sizes = sizes_of_wedge;
  wedge.wedge_shape = wedgeShape;
  wedge.make = [](ParameterList const& list, mesh::VertexLimit const& limit) {
    auto shape = wedgeShape(list);
    shape.limit = limit;
    return mesh::wedgeMesh(shape);
  };
  return wedge;
}

Generator<3> deepWedgeGenerator()
{
  Generator<3> wedge;
  wedge.name = "Deep Wedge";
  wedge.entries = deepWedgeParameters();
  wedge.sizes = std::string(sizes_of_wedge) + ", Depth";
  wedge.wedge_shape = wedgeShape;
  wedge.make = makeDeepWedge;
  return wedge;
}
} // namespace asperity::scenario
