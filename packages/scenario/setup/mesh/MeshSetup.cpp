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
#include "parameters/Entries.hpp"
#include "parameters/fields/Field.hpp"
#include "refinement/UniformRefinement.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/NodalField.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
namespace
{

// The entries of the list `name`, one condition each.
template <int Dim>
std::vector<mesh::NamedCondition<Dim>> conditionsIn(ParameterList const& mesh,
                                                    std::string const& name)
{
  auto const& list = mesh.sublist(name);
  std::vector<mesh::NamedCondition<Dim>> conditions;
  for (auto const& entry : list) {
    auto const condition =
      std::make_shared<Field>(steadyField(list, entry.first, joinPath(mesh_path, name), {}));
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
    throw InputError(joinPath(joinPath(mesh_path, "File"), "File Name") + ": " + error.what());
  }
}

struct MeshSettings
{
  std::string type = "Wedge";
  int most_vertices = 500000;
  int num_refinements = 0;
  std::optional<std::vector<std::string>> flat_cells; // names of boundaries or faults
  double flat_height = 0.3;
};

struct FileOfMesh
{
  std::string name;
};

Entries<FileOfMesh> fileEntries()
{
  return Entries<FileOfMesh>().fileName(
    "File Name", &FileOfMesh::name, required,
    "The mesh is read from this HDF5 file, as asperity-mesh writes it, in two or three dimensions. "
    "A file that asperity-mesh has partitioned must have as many parts as there are ranks. A "
    "relative name is looked for beside the deck, and then from where the program was started.");
}

Entries<MeshSettings> meshEntries()
{
  using S = MeshSettings;
  std::vector<Declare::NamedList> types;
  for (auto const& type : generatedMeshes()) {
    types.emplace_back(type.name, type.entries);
  }
  types.emplace_back("File", fileEntries().list());
  Entries<S> entries;
  entries
    .choiceOfLists(
      "Type", &S::type, types,
      "Selects the shape of the body. In two dimensions it is the analogue wedge (thesis A.1) or a "
      "rectangle; in three dimensions the wedge with a depth along z or a box; in both a mesh from "
      "a file.")
    .integer("Most Vertices", &S::most_vertices, Range::atLeast(3),
             "A mesh that is made here, and not read from a file, has at most this number of "
             "vertices, before 'Refinements'; a larger one is refused before it is made. This "
             "finds a forgotten extent or cell size.")
    .integer("Refinements", &S::num_refinements, Range::atLeast(0),
             "Every cell is divided this number of times, triangles into 4 and tetrahedra into 8, "
             "on all ranks at once, with its region, boundaries and faults. The body keeps the "
             "shape of the coarse mesh, for which the conditions in 'Regions', 'Boundaries' and "
             "'Faults' are evaluated.")
    .textArray(flat_cells_beside, &S::flat_cells, optional,
               "Cells beside these boundaries or faults become flat: their vertices move towards "
               "them, and no cell is added; other faults that they reach move along. Linear cells "
               "make a fault stiffer than rock, the less "
               "the flatter they are ('asperity-bench stiffness'). The conditions in 'Regions', "
               "'Boundaries' and 'Faults' see the positions before. In a Box or a Rectangle "
               "'Flat Cells at' does the same for whole planes.")
    .real("Flat Cell Height", &S::flat_height, "-", Range::openClosed(0, 1),
          "With 'Flat Cells Beside', the first layer of cells is this times as high as without it, "
          "the next layers 1.5 times as much each, until they reach their own height.")
    .others()
    .openSublist(
      "Regions",
      Declare()
        .field("<region>", required, "-", Range::any(),
               "A cell belongs to the region if this condition, evaluated at its centroid, is not "
               "zero. If several regions claim a cell, the last one gets it.")
        .withoutDatasets()
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
        .withoutDatasets()
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
        .withoutDatasets()
        .list(),
      "Each entry defines a fault inside the body by a condition, as abs(y) < 1e-6. The edges of "
      "the cells must lie along it: the mesh is split there, and is not moved.");
  return entries;
}

MeshSettings settingsOf(ParameterList const& list) { return meshEntries().read(list, mesh_path); }

std::string fileNameOf(ParameterList const& list)
{
  return fileEntries().read(list.sublist("File"), joinPath(mesh_path, "File")).name;
}

// This rank's part of the mesh before it is refined.
template <int Dim>
Mesh<Dim> coarsePart(ParameterList const& list, std::string const& fault,
                     mesh::BranchEnd branch_end, RCP<const Communicator> const& communicator)
{
  auto const settings = settingsOf(list);
  auto const regions = conditionsIn<Dim>(list, "Regions");
  auto const boundaries = conditionsIn<Dim>(list, "Boundaries");
  auto const where_regions = joinPath(mesh_path, "Regions");
  auto const where_boundaries = joinPath(mesh_path, "Boundaries");
  auto const faults = conditionsIn<Dim>(list, "Faults");
  auto const where_faults = joinPath(mesh_path, "Faults");
  const bool is_file = !generatedMesh(settings.type);
  auto const file_name = is_file ? fileNameOf(list) : std::string();
  if (is_file &&
      withMeshFileErrors([&] { return mesh::isPartitioned(file_name, *communicator); })) {
    ASPERITY_REQUIRE(!settings.flat_cells,
                     joinPath(mesh_path, flat_cells_beside)
                       << " needs a whole mesh, but mesh file '" << file_name
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
  auto whole =
    is_file ? withMeshFileErrors([&] { return mesh::readMesh<Dim>(file_name, *communicator); })
            : generateMesh<Dim>(list.sublist(settings.type), settings.type, settings.most_vertices);
  mesh::overrideRegions(whole, regions, where_regions);
  mesh::overrideBoundaries(whole, boundaries, where_boundaries);
  mesh::addFaults(whole, faults, where_faults);
  if (settings.flat_cells) {
    mesh::flattenBeside(whole, *settings.flat_cells, settings.flat_height,
                        joinPath(mesh_path, flat_cells_beside));
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

RCP<const ParameterList> meshParameters() { return meshEntries().list(); }

int meshDimension(ParameterList const& list, Communicator const& communicator)
{
  auto const type = settingsOf(list).type;
  if (auto const generated = generatedMesh(type)) {
    return generated->dimension;
  }
  auto const name = fileNameOf(list);
  return withMeshFileErrors([&] { return mesh::fileDimension(name, communicator); });
}

template <int Dim>
Mesh<Dim> makeMesh(ParameterList const& list, std::string const& fault, mesh::BranchEnd branch_end,
                   RCP<const Communicator> const& communicator)
{
  ASPERITY_TIME_WORK("mesh");
  return refinement::refineUniformly(coarsePart<Dim>(list, fault, branch_end, communicator),
                                     settingsOf(list).num_refinements, *communicator,
                                     joinPath(mesh_path, "Refinements"));
}

template Mesh<2> makeMesh(ParameterList const&, std::string const&, mesh::BranchEnd,
                          RCP<const Communicator> const&);
template Mesh<3> makeMesh(ParameterList const&, std::string const&, mesh::BranchEnd,
                          RCP<const Communicator> const&);
} // namespace asperity::scenario
