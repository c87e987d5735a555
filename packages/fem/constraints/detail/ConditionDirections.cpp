#include "fem/constraints/detail/ConditionDirections.hpp"

#include "base/Errors.hpp"
#include "fem/constraints/detail/ConditionNodes.hpp"
#include "fem/constraints/detail/NodalBasis.hpp"

namespace asperity::fem::detail
{
namespace
{
// The unit normals of the walls at each owned node.
template <int Dim>
NodalVectors wallsOf(Mesh<Dim> const& mesh, std::vector<VelocityCondition<Dim>> const& conditions,
                     int components)
{
  NodalVectors result;
  for (auto const& condition : conditions) {
    if (components > 1 && condition.normal() == Normal::of_wall &&
        mesh.boundaries.count(condition.boundary) > 0) {
      for (auto const& [node, normal] : inwardNormals(mesh, components, {condition.boundary})) {
        result[node].push_back(condition.unitDirection(normal));
      }
    }
  }
  return result;
}

// Inward normals at the owned nodes of a condition, not normalised.
template <int Dim>
std::map<int, std::vector<double>> normalsOf(VelocityCondition<Dim> const& condition,
                                             Mesh<Dim> const& mesh, NodalVectors const& walls,
                                             int components)
{
  auto const boundaries = condition.boundariesOfNormal();
  for (auto const& name : boundaries) {
    ASPERITY_REQUIRE(mesh.boundaries.count(name) > 0,
                     condition.name << ": the mesh has no boundary '" << name << "'.");
  }
  auto normals = inwardNormals(mesh, components, boundaries);
  if (condition.normal() == Normal::of_fault) {
    turnIntoWalls(walls, normals);
  }
  return normals;
}

} // namespace

template <int Dim>
NodalDirections collectDirections(Mesh<Dim> const& mesh,
                                  std::vector<VelocityCondition<Dim>> const& conditions,
                                  int components)
{
  auto const walls = wallsOf(mesh, conditions, components);
  NodalDirections result;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    auto const normals = normalsOf(conditions[i], mesh, walls, components);
    for (int node : ownedNodes(mesh, conditions[i].boundary)) {
      const int condition = static_cast<int>(i);
      result[node].push_back(
        {conditions[i].unitDirection(normals.at(node)), condition, {{condition, 1.}}});
    }
  }
  return result;
}

template NodalDirections collectDirections(Mesh<2> const&, std::vector<VelocityCondition<2>> const&,
                                           int);
template NodalDirections collectDirections(Mesh<3> const&, std::vector<VelocityCondition<3>> const&,
                                           int);
} // namespace asperity::fem::detail
