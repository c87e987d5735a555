#include "scenario/setup/FaultNodes.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/SimplexGeometry.hpp"

namespace asperity::scenario
{
namespace
{
// Barycentric coordinates of the centres of equal parts of a facet.
template <int Dim>
std::vector<std::array<double, Dim>> centresOfParts()
{
  std::vector<std::array<double, Dim>> centres;
  if constexpr (Dim == 2) {
    constexpr int parts = 8;
    for (int i = 0; i < parts; ++i) {
      const double x = (i + 0.5) / parts;
      centres.push_back({1 - x, x});
    }
  } else {
    constexpr int rows = 4;
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; i + j < rows; ++j) {
        for (const int upside_down : {0, 1}) {
          if (i + j + upside_down < rows) {
            const double x = (i + (1 + upside_down) / 3.) / rows;
            const double y = (j + (1 + upside_down) / 3.) / rows;
            centres.push_back({1 - x - y, x, y});
          }
        }
      }
    }
  }
  return centres;
}

template <int Dim>
std::shared_ptr<const FieldSamples> samplesAround(Mesh<Dim> const& mesh,
                                                  fem::FaultSurface const& surface)
{
  struct Sample
  {
    std::array<double, 3> place;
    double weight;
  };
  std::vector<std::vector<Sample>> of_nodes(surface.numNodes());
  auto const centres = centresOfParts<Dim>();
  for (auto const& facet : mesh::boundaryFacets(mesh, surface.name())) {
    auto const corners = mesh::corners(mesh, facet);
    const double part = mesh::facetMeasure(corners) / static_cast<double>(centres.size());
    for (auto const& centre : centres) {
      Point<Dim> place{};
      for (int k = 0; k < Dim; ++k) {
        for (int d = 0; d < Dim; ++d) {
          place[d] += centre[k] * corners[k][d];
        }
      }
      for (int k = 0; k < Dim; ++k) {
        if (const int node = surface.nodeAt(facet[k]); node >= 0) {
          of_nodes[node].push_back({inSpace<Dim>(place), centre[k] * part});
        }
      }
    }
  }
  auto result = std::make_shared<FieldSamples>();
  for (int node = 0; node < surface.numNodes(); ++node) {
    double sum = 0;
    for (auto const& sample : of_nodes[node]) {
      sum += sample.weight;
    }
    for (auto const& [place, weight] : of_nodes[node]) {
      result->places.push_back(place);
      result->weights.push_back(weight / sum);
    }
    result->end.push_back(result->places.size());
  }
  return result;
}
// (num_nodes) the first of the faults that has the node.
template <int Dim>
std::vector<int> faultsOfNodes(Mesh<Dim> const& mesh, fem::FaultSurface const& surface,
                               std::vector<std::string> const& faults)
{
  constexpr int none = -1;
  std::vector<int> result(surface.numNodes(), none);
  for (std::size_t fault = 0; fault < faults.size(); ++fault) {
    for (const int vertex : mesh::boundaryVertices(mesh, faults[fault])) {
      const int node = surface.nodeAt(vertex);
      if (node >= 0 && result[node] == none) {
        result[node] = static_cast<int>(fault);
      }
    }
  }
  return result;
}
} // namespace

template <int Dim>
FieldNodes faultNodes(Mesh<Dim> const& mesh, fem::FaultSurface const& surface,
                      std::vector<std::string> const& faults)
{
  FieldNodes nodes(mesh, surface.vertices());
  nodes.fault_names = faults;
  nodes.faults = faultsOfNodes(mesh, surface, faults);
  auto const made = std::make_shared<std::shared_ptr<const FieldSamples>>();
  nodes.samples = [made, &mesh, &surface] {
    if (*made == nullptr) {
      *made = samplesAround(mesh, surface);
    }
    return *made;
  };
  return nodes;
}

template FieldNodes faultNodes(Mesh<2> const&, fem::FaultSurface const&,
                               std::vector<std::string> const&);
template FieldNodes faultNodes(Mesh<3> const&, fem::FaultSurface const&,
                               std::vector<std::string> const&);
} // namespace asperity::scenario
