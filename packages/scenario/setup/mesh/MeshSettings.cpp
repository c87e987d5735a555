#include "scenario/setup/mesh/MeshSettings.hpp"

#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"

namespace asperity::scenario
{
namespace
{
struct FileOfMesh
{
  std::string name;
};

Entries<FileOfMesh> fileEntries()
{
  return Entries<FileOfMesh>().fileName(
    mesh_entries::file_name, &FileOfMesh::name, required,
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
  types.emplace_back(mesh_entries::file, fileEntries().list());
  Entries<S> entries;
  entries
    .choiceOfLists(
      "Type", &S::type, types,
      "Selects the shape of the body. In two dimensions it is the analogue wedge (thesis A.1) or a "
      "rectangle; in three dimensions the wedge with a depth along z or a box; in both a mesh from "
      "a file.")
    .integer(mesh_entries::most_vertices, &S::most_vertices, Range::atLeast(3),
             "A mesh that is made here, and not read from a file, has at most this number of "
             "vertices, before 'Refinements'; a larger one is refused before it is made. This "
             "finds a forgotten extent or cell size.")
    .integer(mesh_entries::refinements, &S::num_refinements, Range::atLeast(0),
             "Every cell is divided this number of times, triangles into 4 and tetrahedra into 8, "
             "on all ranks at once, with its region, boundaries and faults. The body keeps the "
             "shape of the coarse mesh, for which the conditions in 'Regions', 'Boundaries' and "
             "'Faults' are evaluated.")
    .textArray(mesh_entries::flat_cells, &S::flat_cells, optional,
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
      mesh_entries::regions,
      Declare()
        .field("<region>", required, "-", Range::any(),
               "A cell belongs to the region if this condition, evaluated at its centroid, is not "
               "zero. If several regions claim a cell, the last one gets it.")
        .withoutDatasets()
        .list(),
      "Each entry defines a region by a condition. It takes its cells from the regions of the "
      "mesh.")
    .openSublist(
      mesh_entries::boundaries,
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
      mesh_entries::faults,
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
} // namespace

RCP<const ParameterList> meshParameters() { return meshEntries().list(); }

MeshSettings MeshSettings::from(ParameterList const& list)
{
  auto settings = meshEntries().read(list, mesh_path);
  settings.shape = list.sublist(settings.type);
  if (settings.isInFile()) {
    settings.file_name =
      fileEntries().read(settings.shape, joinPath(mesh_path, mesh_entries::file)).name;
  }
  settings.regions = list.sublist(mesh_entries::regions);
  settings.boundaries = list.sublist(mesh_entries::boundaries);
  settings.faults = list.sublist(mesh_entries::faults);
  return settings;
}

bool MeshSettings::isInFile() const { return type == mesh_entries::file; }
} // namespace asperity::scenario
