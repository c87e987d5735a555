#include "building/BuildMesh.hpp"

#include "arrangement/complex/Complex.hpp"
#include "meshing/CellEstimate.hpp"
#include "meshing/EdgeDivision.hpp"
#include "meshing/Features.hpp"
#include "meshing/Relocation.hpp"
#include "meshing/Volume.hpp"
#include "surfaces/TriangleSurface.hpp"

#include <memory>
#include <vector>

namespace asperity::geometry
{
namespace
{
// The size of cells from the parts of faults inside the body.
std::shared_ptr<CellSize> cellSize(Complex const& complex, BuildSettings const& settings)
{
  auto size = std::make_shared<CellSize>(settings.growth, settings.largest);
  std::vector<TriangleSurface> faults(settings.model.num_faults);
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    if (settings.model.isFault(complex.surfaces[i])) {
      faults[complex.surfaces[i]].triangles.push_back(complex.triangles[i]);
    }
  }
  for (std::size_t s = 0; s < faults.size(); ++s) {
    faults[s].points = complex.points;
    size->addFault(
      faults[s], [field = settings.sizes[s]](Point<3> const& place) { return field(place, 0, 0); });
  }
  return size;
}
} // namespace

Arranged arrangeSurfaces(BuildSettings const& settings)
{
  return arrangeModel(settings.model, {settings.snap, settings.stub_share, settings.short_share},
                      [&](Complex const& complex) {
                        return [size = cellSize(complex, settings)](Point<3> const& place) {
                          return (*size)(place);
                        };
                      });
}

CellSize sizeOfCells(Arranged const& arranged, BuildSettings const& settings)
{
  constexpr double smallest_share = 0.02; // of cells in narrow places
  auto size = cellSize(arranged.complex, settings);
  size->addLimits(narrowPlaces(arranged.complex, *size, smallest_share));
  return *size;
}

GlobalMesh<3> meshArranged(Arranged const& arranged, BuildSettings const& settings,
                           CellSize const& size,
                           std::function<void(std::string const&)> const& reportProgress)
{
  auto mesh =
    fillVolume(arranged.complex, settings.model, size,
               expectedCells(arranged.complex, settings.model, size).cells, reportProgress);
  constexpr double wanted_angle = 12, least_angle = 8; // degrees
  int flat = relocateVertices(mesh, arranged.complex, settings.model, wanted_angle);
  if (const int divided = divideEdges(mesh, least_angle); divided > 0) {
    reportProgress("edges of flat cells divided: " + std::to_string(divided));
    flat = relocateVertices(mesh, arranged.complex, settings.model, wanted_angle);
  }
  reportProgress("vertices of flat cells moved; " + std::to_string(flat) + " cells below " +
                 std::to_string(int(wanted_angle)) + " degrees remain");
  mesh::checkMesh(mesh, "The mesh that Gmsh made");
  return mesh;
}
} // namespace asperity::geometry
