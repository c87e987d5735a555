#include "mesh/Regions.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"

namespace asperity::mesh
{
namespace
{
template <int Dim>
int regionNumber(GlobalMesh<Dim>& mesh, std::string const& name)
{
  auto& names = mesh.region_names;
  const auto found = std::find(names.begin(), names.end(), name);
  const auto number = static_cast<int>(found - names.begin());
  if (found == names.end()) {
    names.push_back(name);
  }
  return number;
}

template <int Dim>
std::vector<int> cellsPerRegion(GlobalMesh<Dim> const& mesh)
{
  std::vector<int> count(mesh.region_names.size(), 0);
  for (int region : mesh.cell_regions) {
    ++count[static_cast<std::size_t>(region)];
  }
  return count;
}

template <int Dim>
void dropEmptyRegions(GlobalMesh<Dim>& mesh)
{
  const auto count = cellsPerRegion(mesh);
  std::vector<int> new_number(count.size(), -1);
  std::vector<std::string> names;
  for (std::size_t r = 0; r < count.size(); ++r) {
    if (count[r] > 0) {
      new_number[r] = static_cast<int>(names.size());
      names.push_back(mesh.region_names[r]);
    }
  }
  mesh.region_names = names;
  for (int& region : mesh.cell_regions) {
    region = new_number[static_cast<std::size_t>(region)];
  }
}
} // namespace

template <int Dim>
void overrideRegions(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                     std::string const& where)
{
  for (auto const& condition : conditions) {
    const int region = regionNumber(mesh, condition.name);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      if (condition.holds(centroid(corners<Dim>(mesh.vertices, mesh.cells[c])))) {
        mesh.cell_regions[c] = region;
      }
    }
  }
  const auto count = cellsPerRegion(mesh);
  for (auto const& condition : conditions) {
    ASPERITY_REQUIRE(count[static_cast<std::size_t>(regionNumber(mesh, condition.name))] > 0,
                     where << " / " << condition.name << ": the region has no cell. Its condition "
                           << "holds at no cell's centroid, or later ones take its cells.");
  }
  dropEmptyRegions(mesh);
}

template void overrideRegions(GlobalMesh<2>&, std::vector<NamedCondition<2>> const&,
                              std::string const&);
template void overrideRegions(GlobalMesh<3>&, std::vector<NamedCondition<3>> const&,
                              std::string const&);
} // namespace asperity::mesh
