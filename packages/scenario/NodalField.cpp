#include "scenario/NodalField.hpp"

namespace asperity::scenario
{
namespace
{
// (num local vertices) the region of the first cell that has the vertex.
std::vector<int> vertexRegions(Mesh<2> const& mesh)
{
  std::vector<int> regions(mesh.vertices.size(), -1);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (int vertex : mesh.cells[cell]) {
      if (regions[vertex] < 0) {
        regions[vertex] = mesh.cell_regions[cell];
      }
    }
  }
  return regions;
}
} // namespace

bool isGiven(ParameterList const& list, std::string const& name)
{
  return list.isParameter(name) || list.isSublist(name);
}

Field steadyField(ParameterList const& list, std::string const& name, std::string const& path,
                  Mesh<2> const& mesh)
{
  Field field(list, name, path, mesh.region_names);
  ASPERITY_REQUIRE(!field.dependsOnTime(),
                   joinPath(path, name) << " depends on t, but it is read once, at t = 0. Remove t "
                                           "from the expression.");
  return field;
}

std::vector<double> nodalValues(ParameterList const& list, std::string const& name,
                                std::string const& path, Mesh<2> const& mesh,
                                std::vector<int> const& nodes)
{
  auto const field = steadyField(list, name, path, mesh);
  if (field.isDataset()) {
    std::vector<long long> ids;
    for (int node : nodes) {
      ids.push_back(mesh.global_ids[node]);
    }
    return field.values(ids);
  }
  auto const regions = vertexRegions(mesh);
  std::vector<double> values;
  for (int node : nodes) {
    auto const& x = mesh.vertices[node];
    values.push_back(field({x[0], x[1], 0}, 0, regions[node]));
  }
  return values;
}
} // namespace asperity::scenario
