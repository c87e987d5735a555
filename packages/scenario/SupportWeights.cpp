#include "scenario/SupportWeights.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <cmath>
#include <map>
#include <set>

namespace asperity::scenario
{
namespace
{
// Cosines between the outward normals of fault and wall. What is nearly at right angles is taken
// for that by the frames of the nodes, too.
constexpr double across = 0.1;
constexpr double in_line = 0.9;
} // namespace

template <int Dim>
std::vector<double> supportWeights(Mesh<Dim> const& mesh,
                                   fem::BoundaryNodes<Dim> const& fault_nodes,
                                   std::vector<fem::VelocityCondition<Dim>> const& conditions,
                                   std::string const& fault, std::vector<bool> const& slides)
{
  auto weights = fault_nodes.weights;
  std::map<int, std::size_t> place;
  for (std::size_t i = 0; i < fault_nodes.nodes.size(); ++i) {
    place[fault_nodes.nodes[i]] = i;
  }
  std::set<std::string> seen = {fault};
  for (auto const& condition : conditions) {
    if (!condition.holdsAcross() || !seen.insert(condition.boundary).second) {
      continue;
    }
    for (auto const& facet : mesh.boundaries.at(condition.boundary)) {
      auto const corners = mesh::corners(mesh, facet);
      auto const normal = mesh::areaNormal(corners);
      const double size = std::sqrt(mesh::dot<Dim>(normal, normal));
      for (int node : facet) {
        auto const found = place.find(node);
        if (found == place.end() || !slides[found->second]) {
          continue;
        }
        const std::size_t i = found->second;
        const double cosine = mesh::dot<Dim>(normal, fault_nodes.normals[i]) / size;
        ASPERITY_REQUIRE(std::abs(cosine) < across || cosine > in_line,
                         "Asperity / Friction / Normal Stress is missing: "
                           << condition.name
                           << " holds the fault at an angle that is neither right nor flat, at x = "
                           << mesh::text(mesh.vertices[node])
                           << ", and what of the weight there rests on the fault cannot be told. "
                              "Give it.");
        weights[i] += cosine > in_line ? mesh::facetMeasure(corners) / Dim : 0;
      }
    }
  }
  return weights;
}

template std::vector<double> supportWeights(Mesh<2> const&, fem::BoundaryNodes<2> const&,
                                            std::vector<fem::VelocityCondition<2>> const&,
                                            std::string const&, std::vector<bool> const&);
template std::vector<double> supportWeights(Mesh<3> const&, fem::BoundaryNodes<3> const&,
                                            std::vector<fem::VelocityCondition<3>> const&,
                                            std::string const&, std::vector<bool> const&);
} // namespace asperity::scenario
