#include "TargetFolder.hpp"
#include "Warnings.hpp"
#include "arrangement/Arranged.hpp"
#include "arrangement/complex/Complex.hpp"
#include "building/BuildMesh.hpp"
#include "building/BuildParameters.hpp"
#include "building/BuildReport.hpp"
#include "building/DeckEstimate.hpp"
#include "building/ShortOptions.hpp"
#include "commands/Commands.hpp"
#include "commands/Meshes.hpp"
#include "commands/Partitioning.hpp"
#include "meshing/CellEstimate.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"
#include "mesh/Mesh.hpp"
#include "mesh/TouchingFacets.hpp"
#include "parameters/Deck.hpp"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
// A line with the seconds since the start.
class Progress
{
public:
  void operator()(std::string const& text) const
  {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
    std::cout << formatted("%7.1f s  ", time.count()) << text << std::endl;
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Files
{
  std::string deck, mesh; // "" where not given
};

Files filesOf(Arguments const& arguments, bool is_dry)
{
  Files files;
  for (int i = 0; i < arguments.numFiles(); ++i) {
    auto const& name = arguments.file(i);
    auto& file = std::filesystem::path(name).extension() == ".xml" ? files.deck : files.mesh;
    ASPERITY_REQUIRE(file.empty(), "Unexpected argument '" << name << "'.");
    file = name;
  }
  ASPERITY_REQUIRE(is_dry || !files.mesh.empty(),
                   "The file OUT.h5 is missing. See asperity-mesh --help.");
  return files;
}

BuildSettings settingsOf(Files const& files, ShortOptions const& options)
{
  auto deck =
    files.deck.empty() ? Teuchos::rcp(new ParameterList("Asperity")) : readDeck(files.deck);
  const auto folder = std::filesystem::path(files.deck).parent_path();
  applyOptions(options, *deck, folder);
  auto settings = readBuildSettings(*deck, folder.string());
  ASPERITY_REQUIRE(options.overlays.empty() || !settings.deck.empty(),
                   "Option --overlay " << options.overlays.front()
                                       << ": there is no deck of asperity that it could change. "
                                          "Give --deck RUN.xml, too.");
  settings.overlays = options.overlays;
  return settings;
}

void requireTolerance(GlobalMesh<3> const& mesh, BuildSettings const& settings)
{
  for (int s = 0; settings.tolerance && s < settings.model.num_faults; ++s) {
    auto const& name = settings.model.name(s);
    const auto off =
      largestDistance(mesh.vertices, mesh.boundaries.at(name), settings.model.surfaces[s].surface);
    ASPERITY_REQUIRE(off.distance <= *settings.tolerance,
                     "Fault '" << name << "': the centre of a facet lies "
                               << formatShort(off.distance) << " m from the given surface, at "
                               << placeText(off.place) << ", more than Tolerance = "
                               << *settings.tolerance << ". Give a smaller Cell Size there.");
  }
}

// The mesh split along its faults. A mesh that cannot be split is refused before it is written.
GlobalMesh<3> splitMesh(GlobalMesh<3> const& mesh)
{
  auto split = mesh;
  try {
    mesh::splitFaults(split, "The mesh");
    return split;
  } catch (InputError const& error) {
    throw InputError(error.what() +
                     std::string(" Cut a surface where it meets the others, or raise Trim Stubs "
                                 "over the share of its smaller piece. Nothing is written."));
  }
}

void buildFile(BuildSettings const& settings, Files const& files, bool is_dry,
               Partitioning const& partitioning)
{
  const Progress reportProgress;
  int triangles = 0;
  for (auto const& surface : settings.model.surfaces) {
    triangles += static_cast<int>(surface.surface.triangles.size());
  }
  reportProgress("read " + std::to_string(settings.model.num_faults) +
                 (settings.model.num_faults == 1 ? " fault; " : " faults; ") +
                 std::to_string(triangles) + " triangles with ground and walls");
  for (auto const& remark : settings.remarks) {
    std::cout << remark << '\n';
  }
  const auto arranged = arrangeSurfaces(settings);
  reportProgress("arranged " + std::to_string(arranged.complex.triangles.size()) + " triangles");
  report(arranged, settings.model, std::cout);
  const auto size = sizeOfCells(arranged, settings);
  const auto expected = expectedCells(arranged.complex, settings.model, size);
  report(expected, std::cout);
  if (!settings.deck.empty()) {
    reportDeck(arranged.complex, settings, size, expected, std::cout);
  }
  if (is_dry) {
    return;
  }
  auto mesh = meshArranged(arranged, settings, size, reportProgress);
  report(mesh, settings.model, settings.largest, std::cout);
  if (const auto touching = mesh::touchingFacets(mesh)) {
    warn("'" + files.mesh + "': " + mesh::sentence(*touching));
  }
  requireTolerance(mesh, settings);
  for (auto& x : mesh.vertices) {
    x = settings.is_y_up ? Point<3>{x[0], x[2], -x[1]} : x;
  }
  const auto split = splitMesh(mesh);
  if (partitioning.numParts()) {
    partitioning.write(split, {}, files.mesh);
  } else {
    writeAndReport(mesh, files.mesh);
  }
}

class Build final : public Command
{
public:
  CommandText text() const override
  {
    return {"build",
            "[MODEL.xml] OUT.h5",
            "Makes a mesh from surfaces of faults and ground.",
            {"MODEL.xml", "OUT.h5"},
            0};
  }

  void declareOptions(Arguments& arguments) override
  {
    auto& options = options_;
    arguments
      .values("--fault", options.faults, "NAME=FILE,KEY=VALUE,...",
              "a fault and its surface; keys as units=km, size=500m")
      .value("--ground", options.ground, "FILE,KEY=VALUE,...", "the ground (the plane z = 0)")
      .value("--units", options.units, "m or km", "of the files that name none")
      .value("--size", options.size, "LENGTH", "of cells at faults: 500, 500m, 0.5km")
      .value("--largest", options.largest, "LENGTH", "largest size of cells")
      .value("--growth", options.growth, "NUMBER",
             "growth of cells for each metre of distance (0.3)")
      .value("--margin", options.margin, "LENGTH", "from the faults to the walls")
      .value("--depth", options.depth, "LENGTH", "of the bottom below z = 0")
      .value("--snap", options.snap, "LENGTH",
             "borders this near to another surface are made to meet it (0.1 of the size)")
      .value("--projection", options.projection, "TEXT", "for degrees: utm11, EPSG:32611, ...")
      .values("--set", options.assignments, "PATH/NAME=VALUE", "a parameter of the deck")
      .value("--deck", options.deck, "RUN.xml",
             "a deck of asperity: report what it is to expect of the mesh")
      .values("--overlay", options.overlays, "FILE.xml",
              "lay this over that deck, as asperity does")
      .flag("--dry", is_dry_, "stop before the mesh is made, and report")
      .flag("--print-parameters", prints_, "print the parameters of a deck")
      .value("--format", format_, "text or xml", "of these");
    partitioning_.declare(arguments);
    arguments.overwrite();
  }

  void run(Arguments const& arguments) override
  {
    if (prints_) {
      ASPERITY_REQUIRE(format_ == "text" || format_ == "xml",
                       "Option --format: '" << format_ << "' is not text or xml.");
      return printParameters(*buildParameters(), std::cout,
                             format_ == "xml" ? ParameterFormat::xml : ParameterFormat::text);
    }
    partitioning_.check();
    const auto files = filesOf(arguments, is_dry_);
    if (!is_dry_) {
      arguments.requireNew(files.mesh);
      requireFolder(files.mesh);
    }
    buildFile(settingsOf(files, options_), files, is_dry_, partitioning_);
  }

private:
  ShortOptions options_;
  bool is_dry_ = false, prints_ = false;
  std::string format_ = "text";
  Partitioning partitioning_;
};
} // namespace

std::unique_ptr<Command> buildCommand() { return std::make_unique<Build>(); }
} // namespace asperity::geometry
