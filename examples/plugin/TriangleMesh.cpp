// A format of meshes for asperity-mesh: those of the program Triangle, in the plane. NAME.ele has
// the triangles and perhaps the number of their region, NAME.node the vertices, and NAME.edge, if
// it is there, edges with the number of their boundary (0: none). What is needed is in
// formats/MeshFormat.hpp.
#include "assembly/GroupNaming.hpp"
#include "formats/MeshFormat.hpp"
#include "surfaces/files/TextFile.hpp"

#include <filesystem>
#include <map>

namespace
{
using namespace asperity::geometry;

class Triangle final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".ele"}; }

  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    const std::filesystem::path path(file_name);
    ForeignMesh mesh(2);
    const auto positions =
      readVertices(std::filesystem::path(path).replace_extension(".node"), mesh);
    GroupNaming regions(options.names.regions, regions_option, "number", maker("region_"));
    GroupNaming boundaries(options.names.boundaries, boundaries_option, "number",
                           maker("boundary_"));
    readTriangles(path, positions, regions, mesh);
    const auto edges = std::filesystem::path(path).replace_extension(".edge");
    if (std::filesystem::exists(edges)) {
      readEdges(edges, positions, boundaries, mesh);
    }
    const auto where = "Mesh file '" + file_name + "'";
    regions.finish(where);
    boundaries.finish(where);
    return assemble<2>(mesh, options.assembly, where);
  }

private:
  using Positions = std::map<std::int64_t, int>; // of the vertices in the mesh, by their numbers

  static GroupNaming::Maker maker(std::string const& begin)
  {
    return [begin](std::int64_t number) { return begin + std::to_string(number); };
  }

  // The first line has the number of lines that follow.
  static std::int64_t header(TextFile& file, char const* form)
  {
    if (!file.next()) {
      file.fail("the file is empty");
    }
    file.require(1, form);
    return file.integer(0);
  }

  static void requireNext(TextFile& file, std::int64_t read, std::int64_t all)
  {
    if (!file.next()) {
      file.fail("the file ends after " + std::to_string(read) + " lines of " + std::to_string(all));
    }
  }

  static Positions readVertices(std::filesystem::path const& name, ForeignMesh& mesh)
  {
    TextFile file(name.string(), "Mesh file", '#');
    Positions positions;
    const auto count = header(file, "number of vertices");
    for (std::int64_t i = 0; i < count; ++i) {
      requireNext(file, i, count);
      file.require(3, "vertex x y");
      if (!positions.emplace(file.integer(0), static_cast<int>(i)).second) {
        file.fail("vertex " + std::to_string(file.integer(0)) + " is given twice");
      }
      mesh.numbers.push_back(file.integer(0));
      mesh.vertices.push_back({file.number(1), file.number(2), 0});
    }
    return positions;
  }

  static std::vector<int> verticesOf(TextFile const& file, std::size_t count,
                                     Positions const& positions)
  {
    std::vector<int> vertices;
    for (std::size_t i = 1; i <= count; ++i) {
      const auto found = positions.find(file.integer(i));
      if (found == positions.end()) {
        file.fail("there is no vertex " + std::to_string(file.integer(i)));
      }
      vertices.push_back(found->second);
    }
    return vertices;
  }

  static void readTriangles(std::filesystem::path const& name, Positions const& positions,
                            GroupNaming& regions, ForeignMesh& mesh)
  {
    TextFile file(name.string(), "Mesh file", '#');
    const auto count = header(file, "number of triangles");
    file.require(3, "number of triangles, nodes of each, attributes");
    if (file.integer(1) != 3) {
      file.fail("only triangles of 3 nodes can be read");
    }
    const bool has_regions = file.integer(2) > 0;
    for (std::int64_t i = 0; i < count; ++i) {
      requireNext(file, i, count);
      file.require(has_regions ? 5 : 4, "triangle, three vertices, attributes");
      const auto region = has_regions ? file.integer(4) : 1;
      mesh.addCell(mesh.region(regions.nameOf(region)), verticesOf(file, 3, positions), 3,
                   file.integer(0));
    }
  }

  static void readEdges(std::filesystem::path const& name, Positions const& positions,
                        GroupNaming& boundaries, ForeignMesh& mesh)
  {
    TextFile file(name.string(), "Mesh file", '#');
    const auto count = header(file, "number of edges");
    for (std::int64_t i = 0; i < count; ++i) {
      requireNext(file, i, count);
      file.require(4, "edge, two vertices, number of the boundary");
      if (file.integer(3) != 0) {
        mesh.group(boundaries.nameOf(file.integer(3)))
          .sides.push_back(ForeignMesh::side(verticesOf(file, 2, positions)));
      }
    }
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "Triangle", Triangle)
