#include "building/BuildParameters.hpp"

#include "arrangement/complex/Complex.hpp"
#include "arrangement/preparation/CheckedSurface.hpp"
#include "surfaces/Projection.hpp"
#include "surfaces/TriangleSurface.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

namespace asperity::geometry
{
namespace
{
constexpr char const* root = "Asperity";

using Lists = Teuchos::RCP<const ParameterList>;

Lists faultParameters()
{
  Declare declare;
  declareSurface(declare);
  declare
    .field("Cell Size", optional, "m", Range::positive(),
           "Cells at this fault get this size, in place of the common one.")
    .withoutDatasets();
  return declare.list();
}

Lists groundParameters()
{
  Declare declare;
  declareSurface(declare);
  return declare.list();
}

Lists boxParameters()
{
  const BoxNames names;
  return Declare()
    .real("Margin", optional, "m", Range::positive(),
          "The walls stand this far outside the extent of the faults.")
    .real("Depth", optional, "m", Range::positive(), "The bottom lies this far below z = 0.")
    .realArray("Lower", optional, "m", Range::any(),
               "In place of Margin and Depth: the corner with the least x, y and z.")
    .realArray("Upper", optional, "m", Range::any(),
               "The opposite corner; its z is the height of the ground where no list Ground gives "
               "another one.")
    .text("West", names.west, "Names the wall with the least x.")
    .text("East", names.east, "Names the wall with the largest x.")
    .text("South", names.south, "Names the wall with the least y.")
    .text("North", names.north, "Names the wall with the largest y.")
    .text("Bottom", names.bottom, "Names the bottom.")
    .text("Ground", names.ground, "Names the ground.")
    .list();
}

// Without a list Ground, the ground is flat.
Lists parametersWith(bool has_ground)
{
  Declare declare;
  declare
    .text("Projection", "",
          "Turns degrees into coordinates of the model: what PROJ knows, as 'EPSG:32611', or "
          "'utm11'.")
    .realArray("Origin", std::vector<double>{0, 0}, "m", Range::any(),
               "The origin of the model has these projected coordinates.")
    .openSublist("Faults",
                 Declare().sublist("<fault>", faultParameters(), "A fault, of this name.").list(),
                 "The faults, each with a list of the name that the mesh gives it.")
    .sublist("Box", boxParameters(), "The walls and the bottom.");
  if (has_ground) {
    declare.sublist("Ground", groundParameters(),
                    "The ground; without this list it is the plane z = 0.");
  }
  declare.field("Cell Size", required, "m", Range::positive(), "Cells at faults get this size.")
    .withoutDatasets()
    .real("Growth", 0.3, "-", Range::closed(0.01, 10),
          "The size grows by this much for each metre of distance from the nearest fault.")
    .real("Largest", required, "m", Range::positive(), "No cell gets a larger size.")
    .real("Snap", optional, "m", Range::atLeast(0),
          "Borders of faults that end nearer than this to another surface are made to meet it; "
          "0.1 of the smallest size at faults where it is not given.")
    .real("Trim Stubs", 0.05, "-", Range::closedOpen(0, 1),
          "Pieces that end freely behind another surface are left out if they have less than this "
          "share of their fault's area.")
    .real("Shortest Edge", 0.1, "-", Range::closed(0, 0.5),
          "Parts of curves between surfaces that are shorter than this share of the size of cells "
          "are contracted.")
    .choice("Vertical Axis", "z", {"z", "y"},
            "Selects the axes of the mesh: with z, x points to the east, y to the north and z up, "
            "as in all files and formulas here; with y, x to the east, y up and z to the south.")
    .real("Tolerance", optional, "m", Range::positive(),
          "Refuses a mesh with a facet whose centre is farther than this from the given fault.")
    .fileName("Deck", "",
              "Names a deck of asperity that is to use the mesh, to report unknowns, memory and "
              "cells in the cohesive zone before the mesh is made.");
  return declare.list();
}

Point<3> arrayAt(ParameterList const& list, std::string const& name)
{
  auto const& given = list.get<Teuchos::Array<double>>(name);
  ASPERITY_REQUIRE(given.size() == 3, root << " / Box / " << name << " has " << given.size()
                                           << " numbers, but needs 3.");
  return {given[0], given[1], given[2]};
}

Box boxFrom(ParameterList const& list, std::vector<NamedSurface> const& faults)
{
  const std::string path = std::string(root) + " / Box";
  const bool has_margin = list.isParameter("Margin"), has_depth = list.isParameter("Depth");
  const bool has_lower = list.isParameter("Lower"), has_upper = list.isParameter("Upper");
  ASPERITY_REQUIRE((has_margin && has_depth && !has_lower && !has_upper) ||
                     (has_lower && has_upper && !has_margin && !has_depth),
                   path << " needs Margin and Depth, or Lower and Upper.");
  Box box;
  if (has_lower) {
    box = {arrayAt(list, "Lower"), arrayAt(list, "Upper")};
    for (int d = 0; d < 3; ++d) {
      ASPERITY_REQUIRE(box.low[d] < box.high[d],
                       path << " / Lower = " << placeText(box.low)
                            << " is not below Upper = " << placeText(box.high) << '.');
    }
    return box;
  }
  const double margin = list.get<double>("Margin");
  for (int d = 0; d < 2; ++d) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (auto const& fault : faults) {
      for (auto const& point : fault.surface.points) {
        low = std::min(low, point[d]);
        high = std::max(high, point[d]);
      }
    }
    box.low[d] = low - margin;
    box.high[d] = high + margin;
  }
  box.low[2] = -list.get<double>("Depth");
  box.high[2] = 0;
  return box;
}

// Walls and the bottom may share a name, and are one boundary then.
BoxNames namesFrom(ParameterList const& box, std::vector<NamedSurface> const& faults)
{
  BoxNames names;
  std::vector<std::string> known;
  for (auto const& fault : faults) {
    known.push_back(fault.name);
  }
  const auto read = [&](std::string const& key, std::string& name) {
    name = box.get<std::string>(key);
    ASPERITY_REQUIRE(!name.empty() && std::count(known.begin(), known.end(), name) == 0,
                     root << " / Box / " << key << " = '" << name << "' is empty, or the name of "
                          << (key == "Ground" ? "another surface." : "a fault."));
  };
  read("West", names.west);
  read("East", names.east);
  read("South", names.south);
  read("North", names.north);
  read("Bottom", names.bottom);
  known.insert(known.end(), {names.west, names.east, names.south, names.north, names.bottom});
  read("Ground", names.ground);
  return names;
}

// A fault, or a sheet of one that branches, and the list that it stands in.
struct GivenFault
{
  NamedSurface named;
  std::string list;
};

std::vector<GivenFault> faultsFrom(ParameterList const& list, SurfaceContext const& context)
{
  std::vector<GivenFault> faults;
  for (auto const& entry : list) {
    auto const& name = entry.first;
    const auto path = joinPath(std::string(root) + " / Faults", name);
    auto sheets =
      checkedSheets(makeSurface(list.sublist(name), path, context), "Fault '" + name + "'");
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      const auto own = sheets.size() == 1 ? name : name + "." + std::to_string(i + 1);
      ASPERITY_REQUIRE(own == name || !list.isSublist(own),
                       path << " branches, and its sheet " << i + 1 << " would be called '" << own
                            << "', as another fault is. Give that one another name.");
      faults.push_back({{own, std::move(sheets[i])}, name});
    }
  }
  return faults;
}

std::vector<NamedSurface> surfacesOf(std::vector<GivenFault> const& faults)
{
  std::vector<NamedSurface> surfaces;
  for (auto const& fault : faults) {
    surfaces.push_back(fault.named);
  }
  return surfaces;
}

std::vector<std::string> remarksOn(std::vector<GivenFault> const& faults)
{
  std::map<std::string, std::string> sheets;
  for (auto const& fault : faults) {
    if (fault.named.name != fault.list) {
      auto& names = sheets[fault.list];
      names += (names.empty() ? "'" : ", '") + fault.named.name + "'";
    }
  }
  std::vector<std::string> remarks;
  for (auto const& [fault, names] : sheets) {
    remarks.push_back("fault '" + fault + "' branches; its sheets become the faults " + names);
  }
  return remarks;
}

SurfaceContext contextFrom(ParameterList const& list, std::string const& folder,
                           std::optional<Projection>& projection)
{
  const auto origin = list.get<Teuchos::Array<double>>("Origin");
  ASPERITY_REQUIRE(origin.size() == 2,
                   root << " / Origin has " << origin.size() << " numbers, but needs 2.");
  SurfaceContext context;
  context.folder = folder;
  context.origin = {origin[0], origin[1]};
  auto const& definition = list.get<std::string>("Projection");
  if (!definition.empty()) {
    projection.emplace(definition, std::string(root) + " / Projection");
    context.projection = &*projection;
  }
  return context;
}

// The ground has to reach beyond the walls.
MapArea areaAround(Box const& box)
{
  constexpr double more = 0.02; // of the larger side
  const double margin = more * std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  return {{box.low[0] - margin, box.low[1] - margin}, {box.high[0] + margin, box.high[1] + margin}};
}

double highest(TriangleSurface const& surface)
{
  double height = surface.points.front()[2];
  for (auto const& point : surface.points) {
    height = std::max(height, point[2]);
  }
  return height;
}

// The smallest size at points of faults. InputError for a formula that has no value at one of them.
double smallestSize(BuildSettings const& settings)
{
  double smallest = settings.largest;
  for (int s = 0; s < settings.model.num_faults; ++s) {
    for (auto const& point : settings.model.surfaces[s].surface.points) {
      smallest = std::min(smallest, settings.sizes[s](point, 0, 0));
    }
  }
  return smallest;
}
} // namespace

Teuchos::RCP<const ParameterList> buildParameters() { return parametersWith(true); }

BuildSettings readBuildSettings(ParameterList& list, std::string const& folder)
{
  const bool has_ground = list.isSublist("Ground");
  ASPERITY_REQUIRE(list.isSublist("Faults") && list.sublist("Faults").numParams() > 0,
                   root << " / Faults is missing or empty: a fault has a list there.");
  auto& faults = list.sublist("Faults");
  for (auto const& item : faults) {
    if (faults.isSublist(item.first)) {
      chooseSurfaceType(faults.sublist(item.first),
                        joinPath(std::string(root) + " / Faults", item.first));
    }
  }
  if (has_ground) {
    chooseSurfaceType(list.sublist("Ground"), std::string(root) + " / Ground");
  }
  completeAndValidate(list, *parametersWith(has_ground), root);

  std::optional<Projection> projection;
  auto context = contextFrom(list, folder, projection);
  BuildSettings settings;
  auto given = faultsFrom(faults, context);
  const auto box = boxFrom(list.sublist("Box"), surfacesOf(given));
  TriangleSurface ground;
  if (has_ground) {
    context.area = areaAround(box);
    ground = checkedSurface(
      makeSurface(list.sublist("Ground"), std::string(root) + " / Ground", context), "The ground");
    context.area.reset();
    context.highest_ground = highest(ground);
    context.remark = [](std::string const&) {}; // remarks are printed at the first reading
    given = faultsFrom(faults, context);        // once more, since some extend up to the ground
  }
  auto surfaces = surfacesOf(given);
  const auto names = namesFrom(list.sublist("Box"), surfaces);
  for (auto const& fault : given) {
    auto const& of_fault = faults.sublist(fault.list);
    const bool is_own = isGiven(of_fault, "Cell Size");
    settings.sizes.emplace_back(is_own ? of_fault : list, "Cell Size",
                                is_own ? joinPath(std::string(root) + " / Faults", fault.list)
                                       : root,
                                std::vector<std::string>{"body"});
  }
  settings.remarks = remarksOn(given);
  settings.model = makeModel(std::move(surfaces), std::move(ground), box, names);
  settings.growth = list.get<double>("Growth");
  settings.largest = list.get<double>("Largest");
  settings.stub_share = list.get<double>("Trim Stubs");
  settings.is_y_up = list.get<std::string>("Vertical Axis") == "y";
  settings.short_share = list.get<double>("Shortest Edge");
  constexpr double usual_snap = 0.1; // of the smallest cells
  const double smallest = smallestSize(settings);
  settings.snap = list.isParameter("Snap") ? list.get<double>("Snap") : usual_snap * smallest;
  if (auto const& deck = list.get<std::string>("Deck"); !deck.empty()) {
    settings.deck = (std::filesystem::path(folder) / deck).string();
  }
  if (list.isParameter("Tolerance")) {
    settings.tolerance = list.get<double>("Tolerance");
  }
  return settings;
}
} // namespace asperity::geometry
