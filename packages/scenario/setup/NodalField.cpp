#include "scenario/setup/NodalField.hpp"

#include "mesh/PointText.hpp"

#include <utility>

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

Field steadyField(ParameterList const& list, std::string const& name, std::string const& path,
                  std::vector<std::string> const& region_names, std::vector<bool> const& used,
                  std::vector<std::string> const& fault_names)
{
  Field field(list, name, path, region_names, used, fault_names);
  ASPERITY_REQUIRE(!field.dependsOnTime(),
                   joinPath(path, name) << " depends on t, but it is read once, at t = 0. Remove t "
                                           "from the expression.");
  return field;
}

template <int Dim>
FieldNodes::FieldNodes(Mesh<Dim> const& mesh, std::vector<int> const& vertices)
    : dimension(Dim)
    , region_names(mesh.region_names)
    , num_global_vertices(mesh.num_global_vertices)
{
  auto const region_of = vertexRegions(mesh);
  for (const int vertex : vertices) {
    places.push_back(inSpace<Dim>(mesh.vertices[vertex]));
    regions.push_back(region_of[vertex]);
    ids.push_back(mesh.global_ids[vertex]);
  }
}

template FieldNodes::FieldNodes(Mesh<2> const&, std::vector<int> const&);
template FieldNodes::FieldNodes(Mesh<3> const&, std::vector<int> const&);

std::string FieldNodes::text(std::size_t node) const
{
  auto const& x = places[node];
  return dimension == 2 ? mesh::text(Point<2>{x[0], x[1]}) : mesh::text(x);
}

Expression::Patch FieldSamples::around(std::size_t node) const
{
  const std::size_t begin = node == 0 ? 0 : end[node - 1];
  return {&places[begin], &weights[begin], end[node] - begin};
}

NodalField::NodalField(Field field, FieldNodes const& nodes) : field_(std::move(field))
{
  if (field_.isDataset()) {
    values_ = field_.values(nodes.ids, nodes.num_global_vertices);
  } else {
    places_ = nodes.places;
    parts_ = field_.isPerFault() ? nodes.faults : nodes.regions;
    if (nodes.samples && field_.takesMeans()) {
      samples_ = nodes.samples();
    }
  }
}

NodalField::NodalField(ParameterList const& list, std::string const& name, std::string const& path,
                       FieldNodes const& nodes)
    : NodalField(Field(list, name, path, nodes.region_names, {}, nodes.fault_names), nodes)
{
}

std::vector<double> NodalField::at(double t) const
{
  if (field_.isDataset()) {
    return values_;
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    values.push_back(samples_ ? field_(places_[i], t, parts_[i], samples_->around(i))
                              : field_(places_[i], t, parts_[i]));
  }
  return values;
}

std::vector<double> nodalValues(ParameterList const& list, std::string const& name,
                                std::string const& path, FieldNodes const& nodes)
{
  return NodalField(steadyField(list, name, path, nodes.region_names, {}, nodes.fault_names), nodes)
    .at(0);
}

template <int Dim>
void CellField::read(Mesh<Dim> const& mesh)
{
  if (!field_.isDataset() || !means_.empty()) {
    return;
  }
  const std::vector<long long> ids(mesh.global_ids.begin(), mesh.global_ids.end());
  const auto values = field_.values(ids, mesh.num_global_vertices);
  means_.reserve(mesh.cells.size());
  for (auto const& cell : mesh.cells) {
    double sum = 0;
    for (const int vertex : cell) {
      sum += values[vertex];
    }
    means_.push_back(sum / static_cast<double>(cell.size()));
  }
}

template void CellField::read(Mesh<2> const&);
template void CellField::read(Mesh<3> const&);
} // namespace asperity::scenario
