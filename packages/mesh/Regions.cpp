#include "mesh/Regions.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <Teuchos_DefaultSerialComm.hpp>

namespace asperity::mesh
{
namespace
{
template <class AnyMesh>
int regionNumber(AnyMesh& mesh, std::string const& name)
{
  auto& names = mesh.region_names;
  const auto found = std::find(names.begin(), names.end(), name);
  const auto number = static_cast<int>(found - names.begin());
  if (found == names.end()) {
    names.push_back(name);
  }
  return number;
}

// The entry of a region is 1 if it has a cell in this mesh.
template <class AnyMesh>
std::vector<int> regionsWithCells(AnyMesh const& mesh)
{
  std::vector<int> has_cells(mesh.region_names.size(), 0);
  for (int region : mesh.cell_regions) {
    has_cells[static_cast<std::size_t>(region)] = 1;
  }
  return has_cells;
}

template <class AnyMesh>
void dropRegions(AnyMesh& mesh, std::vector<int> const& is_kept)
{
  std::vector<int> new_number(is_kept.size(), -1);
  std::vector<std::string> names;
  for (std::size_t r = 0; r < is_kept.size(); ++r) {
    if (is_kept[r]) {
      new_number[r] = static_cast<int>(names.size());
      names.push_back(mesh.region_names[r]);
    }
  }
  mesh.region_names = names;
  for (int& region : mesh.cell_regions) {
    region = new_number[static_cast<std::size_t>(region)];
  }
}

template <int Dim, class AnyMesh>
void assignRegions(AnyMesh& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                   std::string const& where, Communicator const& communicator)
{
  for (auto const& condition : conditions) {
    const int region = regionNumber(mesh, condition.name);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      if (condition.holds(centroid(corners(mesh, mesh.cells[c])))) {
        mesh.cell_regions[c] = region;
      }
    }
  }
  const std::vector<int> has_cells = maxOverRanks(regionsWithCells(mesh), communicator);
  for (auto const& condition : conditions) {
    ASPERITY_REQUIRE(
      has_cells[static_cast<std::size_t>(regionNumber(mesh, condition.name))] > 0,
      where << " / " << condition.name << ": the region has no cell. Its condition "
            << "holds at no cell's centroid, or the conditions of later regions take its cells.");
  }
  dropRegions(mesh, has_cells);
}
} // namespace

template <int Dim>
void overrideRegions(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                     std::string const& where)
{
  assignRegions(mesh, conditions, where, Teuchos::SerialComm<int>());
}

template <int Dim>
void overrideRegions(Mesh<Dim>& part, std::vector<NamedCondition<Dim>> const& conditions,
                     Communicator const& communicator, std::string const& where)
{
  assignRegions(part, conditions, where, communicator);
}

template void overrideRegions(GlobalMesh<2>&, std::vector<NamedCondition<2>> const&,
                              std::string const&);
template void overrideRegions(GlobalMesh<3>&, std::vector<NamedCondition<3>> const&,
                              std::string const&);
template void overrideRegions(Mesh<2>&, std::vector<NamedCondition<2>> const&, Communicator const&,
                              std::string const&);
template void overrideRegions(Mesh<3>&, std::vector<NamedCondition<3>> const&, Communicator const&,
                              std::string const&);
} // namespace asperity::mesh
