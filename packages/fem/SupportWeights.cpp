#include "fem/SupportWeights.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <cmath>
#include <set>

namespace asperity::fem
{
namespace
{
// Limits of the cosine between the outward normals of fault and wall. The frames of the nodes use
// the same limit for walls that are nearly perpendicular to the fault.
constexpr double nearly_across = 0.1;
constexpr double in_line = 0.9;
} // namespace

template <int Dim>
std::vector<double> supportWeights(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                   std::vector<VelocityCondition<Dim>> const& conditions)
{
  auto const& of_fault = mesh.boundaries.at(fault.name());
  const std::set<typename Mesh<Dim>::Facet> counted(of_fault.begin(), of_fault.end());
  std::vector<double> weights;
  for (auto const& node : fault) {
    weights.push_back(node.weight);
  }
  std::set<std::string> seen;
  for (auto const& condition : conditions) {
    if (!condition.holdsAcross() || !seen.insert(condition.boundary).second) {
      continue;
    }
    for (auto const& facet : mesh.boundaries.at(condition.boundary)) {
      if (counted.count(facet) > 0) {
        continue;
      }
      auto const corners = mesh::corners(mesh, facet);
      auto const normal = mesh::areaNormal(corners);
      const double size = std::sqrt(mesh::dot<Dim>(normal, normal));
      for (int vertex : facet) {
        const int node = fault.nodeAt(vertex);
        if (node < 0 || !fault.slides(node)) {
          continue;
        }
        double cosine = 0;
        for (int d = 0; d < Dim; ++d) {
          cosine += normal[d] * fault[node].normal[d];
        }
        cosine /= size;
        ASPERITY_REQUIRE(std::abs(cosine) < nearly_across || cosine > in_line,
                         "The normal stress of the fault cannot be computed from gravity at x = "
                           << mesh::text(mesh.vertices[vertex]) << ": the boundary of "
                           << condition.name
                           << " bears an unknown share of the weight there, because it is neither "
                              "perpendicular to the fault nor in line with it. Give "
                              "Friction / Normal Stress.");
        weights[node] += cosine > in_line ? mesh::facetMeasure(corners) / Dim : 0;
      }
    }
  }
  return weights;
}

template std::vector<double> supportWeights(Mesh<2> const&, FaultSurface const&,
                                            std::vector<VelocityCondition<2>> const&);
template std::vector<double> supportWeights(Mesh<3> const&, FaultSurface const&,
                                            std::vector<VelocityCondition<3>> const&);
} // namespace asperity::fem
