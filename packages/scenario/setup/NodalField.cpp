#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
namespace
{
// (num local vertices) the region of the first cell that has the vertex; at the tip of a fault that
// has the other vertex there.
template <int Dim>
std::vector<int> vertexRegions(Mesh<Dim> const& mesh)
{
  std::vector<int> regions(mesh.vertices.size(), -1);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (int vertex : mesh.cells[cell]) {
      if (regions[vertex] < 0) {
        regions[vertex] = mesh.cell_regions[cell];
      }
    }
  }
  for (auto const& split : mesh.splits) {
    if (split.is_tip) {
      regions[split.plus] = regions[split.minus];
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
                  std::vector<std::string> const& region_names)
{
  Field field(list, name, path, region_names);
  ASPERITY_REQUIRE(!field.dependsOnTime(),
                   joinPath(path, name) << " depends on t, but it is read once, at t = 0. Remove t "
                                           "from the expression.");
  return field;
}

template <int Dim>
NodalField::NodalField(ParameterList const& list, std::string const& name, std::string const& path,
                       Mesh<Dim> const& mesh, std::vector<int> const& nodes)
    : field_(list, name, path, mesh.region_names)
{
  if (field_.isDataset()) {
    std::vector<long long> ids;
    ids.reserve(nodes.size());
    for (int node : nodes) {
      ids.push_back(mesh.global_ids[node]);
    }
    values_ = field_.values(ids, mesh.num_global_vertices);
    return;
  }
  auto const regions = vertexRegions(mesh);
  for (int node : nodes) {
    places_.push_back(inSpace<Dim>(mesh.vertices[node]));
    regions_.push_back(regions[node]);
  }
}

std::vector<double> NodalField::at(double t) const
{
  if (field_.isDataset()) {
    return values_;
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    values.push_back(field_(places_[i], t, regions_[i]));
  }
  return values;
}

template <int Dim>
std::vector<double> nodalValues(ParameterList const& list, std::string const& name,
                                std::string const& path, Mesh<Dim> const& mesh,
                                std::vector<int> const& nodes)
{
  steadyField(list, name, path, mesh.region_names);
  return NodalField(list, name, path, mesh, nodes).at(0);
}

#define ASPERITY_INSTANTIATE(Dim)                                                                  \
  template NodalField::NodalField(ParameterList const&, std::string const&, std::string const&,    \
                                  Mesh<Dim> const&, std::vector<int> const&);                      \
  template std::vector<double> nodalValues(ParameterList const&, std::string const&,               \
                                           std::string const&, Mesh<Dim> const&,                   \
                                           std::vector<int> const&);

ASPERITY_INSTANTIATE(2)
ASPERITY_INSTANTIATE(3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::scenario
