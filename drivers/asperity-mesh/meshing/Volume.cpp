#include "meshing/Volume.hpp"

#include "arrangement/complex/Complex.hpp"
#include "gmsh/GmshSession.hpp"
#include "meshing/DiscreteModel.hpp"
#include "meshing/MeshInGmsh.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <gmsh.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace asperity::geometry
{
namespace
{
namespace model = gmsh::model;
using ProgressSink = std::function<void(std::string const&)>;

// The errors that Gmsh has reported.
std::string gmshErrors()
{
  std::vector<std::string> lines;
  gmsh::logger::get(lines);
  std::string text;
  int number = 0;
  for (auto const& line : lines) {
    const bool is_error = line.rfind("Error", 0) == 0 || line.rfind("Warning", 0) == 0;
    if (is_error && number < 5) {
      text += "\n  Gmsh: " + line;
      ++number;
    }
  }
  return text;
}

void generate(int dimension)
{
  constexpr char const* what[] = {"", "curves", "surfaces", "volume"};
  const auto error = errorOfGmsh([&] { model::mesh::generate(dimension); });
  ASPERITY_REQUIRE(error.empty(), "Gmsh cannot mesh the " << what[dimension] << ": " << error
                                                          << ". Try a smaller Cell Size at the "
                                                             "place, or a larger Snap."
                                                          << gmshErrors());
}

void setOptions()
{
  constexpr int frontal = 6, delaunay = 1; // of surfaces, of volumes
  gmsh::option::setNumber("General.NumThreads", 1);
  for (auto const* name : {"Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints",
                           "Mesh.MeshSizeFromCurvature"}) {
    gmsh::option::setNumber(name, 0);
  }
  gmsh::option::setNumber("Mesh.Algorithm", frontal);
  gmsh::option::setNumber("Mesh.Algorithm3D", delaunay);
  gmsh::option::setNumber("Mesh.Optimize", 1);
}

// Gmsh's size at a place of an entity; newer versions give their own size as the last argument.
template <class SizeAt>
void setSize(SizeAt const& size)
{
#if GMSH_API_VERSION_MAJOR > 4 || GMSH_API_VERSION_MINOR > 8
  model::mesh::setSizeCallback(
    [size](int dimension, int entity, double x, double y, double z, double) {
      return size(dimension, entity, {x, y, z});
    });
#else
  model::mesh::setSizeCallback([size](int dimension, int entity, double x, double y, double z) {
    return size(dimension, entity, {x, y, z});
  });
#endif
}

// The progress of the volume, estimated from the number of sizes that Gmsh has requested there.
class FillProgress
{
public:
  FillProgress(double expected_cells, ProgressSink const& reportProgress)
      : expected_(calls_per_cell * expected_cells)
      , tell_(reportProgress)
  {
  }

  // The first calls do not count: Gmsh spends much time on preparations between them.
  void count()
  {
    if (++number_ % calls_between_looks != 0) {
      return;
    }
    const auto now = Clock::now();
    if (number_ == calls_between_looks) {
      start_ = last_ = now;
    }
    if (now - last_ < interval) {
      return;
    }
    last_ = now;
    const auto done = static_cast<double>(number_ - calls_between_looks);
    const double share = done / expected_;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    tell_(share < 0.95
            ? "the volume is filled to about " + formatted("%.0f", 100 * share) + " %, about " +
                formatted("%.0f", seconds * (1 / share - 1)) + " s are left"
            : "the volume is nearly filled");
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr double calls_per_cell = 0.1; // measured
  static constexpr long long calls_between_looks = 64;
  static constexpr std::chrono::seconds interval{10};

  double expected_;
  ProgressSink const& tell_;
  long long number_ = 0;
  Clock::time_point start_, last_;
};
} // namespace

GlobalMesh<3> fillVolume(Complex const& complex, Model const& model, CellSize const& size,
                         double expected_cells, ProgressSink const& reportProgress)
{
  const GmshSession session(false);
  gmsh::logger::start();
  setOptions();
  model::add("built");
  DiscreteModel discrete(complex, model);
  const auto error = errorOfGmsh([&] { discrete.build(); });
  ASPERITY_REQUIRE(error.empty(),
                   "Gmsh cannot take the surfaces: " << error << '.' << gmshErrors());
  const auto widths = discrete.widths();
  FillProgress progress(expected_cells, reportProgress);
  setSize([&](int dimension, int entity, Point<3> const& place) {
    if (dimension == 3) {
      progress.count();
    }
    const auto width = widths.find({dimension, entity});
    const double at_place = size(place);
    return width == widths.end() ? at_place : std::min(at_place, width->second);
  });
  generate(1);
  generate(2);
  std::vector<std::size_t> tags, nodes;
  model::mesh::getElementsByType(type_triangle, tags, nodes);
  reportProgress("surfaces have " + std::to_string(tags.size()) + " facets");
  generate(3);
  auto mesh = meshInGmsh(discrete.surfacesByName());
  reportProgress("the volume has " + std::to_string(mesh.cells.size()) + " cells");
  model::mesh::removeSizeCallback();
  mesh::orientCells(mesh);
  mesh::orientFacets(mesh);
  return mesh;
}
} // namespace asperity::geometry
