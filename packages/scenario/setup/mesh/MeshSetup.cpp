#include "scenario/setup/mesh/MeshSetup.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/Regions.hpp"
#include "mesh/faults/Faults.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"
#include "mesh/generation/FlatCells.hpp"
#include "mesh/parallel/Partition.hpp"
#include "parameters/fields/Field.hpp"
#include "refinement/UniformRefinement.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::scenario
{
namespace
{
// The conditions of a list, each an entry. path: of the list.
template <int Dim>
std::vector<mesh::NamedCondition<Dim>> conditionsIn(ParameterList const& list,
                                                    std::string const& path)
{
  std::vector<mesh::NamedCondition<Dim>> conditions;
  for (auto const& entry : list) {
    auto const condition = std::make_shared<Field>(steadyField(list, entry.first, path, {}));
    conditions.push_back({entry.first, [condition](Point<Dim> const& x) {
                            return (*condition)(inSpace<Dim>(x), 0, 0) != 0;
                          }});
  }
  return conditions;
}

// The result of read(), which reads the mesh file; its InputErrors get the path of the parameter.
template <class Read>
auto withMeshFileErrors(Read const& read)
{
  try {
    return read();
  } catch (InputError const& error) {
    throw InputError(joinPath(joinPath(mesh_path, mesh_entries::file), mesh_entries::file_name) +
                     ": " + error.what());
  }
}

// This rank's part of the mesh before it is refined.
template <int Dim>
Mesh<Dim> coarsePart(MeshSettings const& settings, std::string const& fault,
                     mesh::BranchEnd branch_end, RCP<const Communicator> const& communicator)
{
  auto const where_regions = joinPath(mesh_path, mesh_entries::regions);
  auto const where_boundaries = joinPath(mesh_path, mesh_entries::boundaries);
  auto const where_faults = joinPath(mesh_path, mesh_entries::faults);
  auto const where_flat = joinPath(mesh_path, mesh_entries::flat_cells);
  auto const regions = conditionsIn<Dim>(settings.regions, where_regions);
  auto const boundaries = conditionsIn<Dim>(settings.boundaries, where_boundaries);
  auto const faults = conditionsIn<Dim>(settings.faults, where_faults);
  auto const& file_name = settings.file_name;
  const bool is_file = settings.isInFile();
  if (is_file &&
      withMeshFileErrors([&] { return mesh::isPartitioned(file_name, *communicator); })) {
    ASPERITY_REQUIRE(
      !settings.flat_cells,
      where_flat << " needs a whole mesh, but mesh file '" << file_name
                 << "' is partitioned. Run on the whole mesh, or leave this entry out.");
    ASPERITY_REQUIRE(faults.empty(),
                     where_faults << " / " << faults.front().name << ": mesh file '" << file_name
                                  << "' is partitioned, and was split along its faults before. "
                                  << "Put the fault into the mesh and then partition it.");
    auto part = withMeshFileErrors([&] { return mesh::readPart<Dim>(file_name, communicator); });
    mesh::overrideRegions(part, regions, *communicator, where_regions);
    mesh::overrideBoundaries(part, boundaries, *communicator, where_boundaries);
    return part;
  }
  auto whole = is_file
                 ? withMeshFileErrors([&] { return mesh::readMesh<Dim>(file_name, *communicator); })
                 : generateMesh<Dim>(settings.shape, settings.type, settings.most_vertices);
  mesh::overrideRegions(whole, regions, where_regions);
  mesh::overrideBoundaries(whole, boundaries, where_boundaries);
  mesh::addFaults(whole, faults, where_faults);
  if (settings.flat_cells) {
    mesh::flattenBeside(whole, *settings.flat_cells, settings.flat_height, where_flat);
  }
  if (is_file || !faults.empty()) { // generators make none
    mesh::splitFaults(whole, mesh_path, branch_end);
  }
  mesh::PartitionOptions options;
  options.boundary = whole.boundaries.count(fault) > 0 ? fault : "";
  options.by_cells = settings.num_refinements > 0;
  return mesh::distribute(whole, *communicator, options);
}
} // namespace

int meshDimension(ParameterList const& list, Communicator const& communicator)
{
  auto const settings = MeshSettings::from(list);
  if (auto const generated = generatedMesh(settings.type)) {
    return generated->dimension;
  }
  return withMeshFileErrors([&] { return mesh::fileDimension(settings.file_name, communicator); });
}

template <int Dim>
Mesh<Dim> makeMesh(MeshSettings const& settings, std::string const& fault,
                   mesh::BranchEnd branch_end, RCP<const Communicator> const& communicator)
{
  ASPERITY_TIME_WORK("mesh");
  return refinement::refineUniformly(coarsePart<Dim>(settings, fault, branch_end, communicator),
                                     settings.num_refinements, *communicator,
                                     joinPath(mesh_path, mesh_entries::refinements));
}

template Mesh<2> makeMesh(MeshSettings const&, std::string const&, mesh::BranchEnd,
                          RCP<const Communicator> const&);
template Mesh<3> makeMesh(MeshSettings const&, std::string const&, mesh::BranchEnd,
                          RCP<const Communicator> const&);
} // namespace asperity::scenario
