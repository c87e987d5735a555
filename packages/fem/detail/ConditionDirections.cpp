#include "fem/detail/ConditionDirections.hpp"

#include "base/Errors.hpp"
#include "fem/detail/ConditionNodes.hpp"
#include "fem/detail/NodalBasis.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity::fem::detail
{
namespace
{
// A wall that the body slides along.
template <int Dim>
bool isWall(VelocityCondition<Dim> const& condition)
{
  return condition.direction.empty() && !condition.velocity && !condition.tangential &&
         !condition.free && condition.continued_by.empty();
}

template <int Dim>
bool followsFault(VelocityCondition<Dim> const& condition)
{
  return condition.free || condition.tangential || !condition.continued_by.empty();
}

void normalise(std::vector<double>& direction, std::string const& condition)
{
  const double size = std::sqrt(dot(direction, direction));
  ASPERITY_REQUIRE(size > 0, condition << ": the direction has no length.");
  for (double& x : direction) {
    x /= size;
  }
}

// The unit normals of the walls at each owned node.
template <int Dim>
NodalVectors wallsOf(Mesh<Dim> const& mesh, std::vector<VelocityCondition<Dim>> const& conditions,
                     int components)
{
  NodalVectors result;
  for (auto const& condition : conditions) {
    if (components > 1 && isWall(condition) && mesh.boundaries.count(condition.boundary) > 0) {
      for (auto& [node, normal] : inwardNormals(mesh, components, {condition.boundary})) {
        normalise(normal, condition.name);
        result[node].push_back(normal);
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
  auto boundaries = condition.continued_by;
  boundaries.push_back(condition.boundary);
  // In one order for all that continue each other: the same normals, to the last digit.
  std::sort(boundaries.begin(), boundaries.end());
  boundaries.erase(std::unique(boundaries.begin(), boundaries.end()), boundaries.end());
  for (auto const& name : boundaries) {
    ASPERITY_REQUIRE(mesh.boundaries.count(name) > 0,
                     condition.name << ": the mesh has no boundary '" << name << "'.");
  }
  auto normals = inwardNormals(mesh, components, boundaries);
  if (followsFault(condition)) {
    turnIntoWalls(walls, normals);
  }
  return normals;
}

// Of a condition along a boundary, from its unit normal.
template <int Dim>
std::vector<double> tangentOf(VelocityCondition<Dim> const& condition,
                              std::vector<double> const& normal)
{
  if (normal.size() < 3) {
    return completing({normal}, static_cast<int>(normal.size()));
  }
  auto const& towards = condition.towards;
  ASPERITY_ASSERT(towards.size() == 3);
  auto tangent = withinPlane(normal, towards, condition.at_right_angles);
  ASPERITY_REQUIRE(dot(tangent, tangent) > parallel * dot(towards, towards),
                   condition.name << ": the direction (" << towards[0] << ", " << towards[1] << ", "
                                  << towards[2] << ") stands at right angles on the boundary '"
                                  << condition.boundary
                                  << "', so that nothing of it lies along it. Give another one.");
  normalise(tangent, condition.name);
  return tangent;
}

template <int Dim>
std::vector<int> nodesOf(VelocityCondition<Dim> const& condition, Mesh<Dim> const& mesh)
{
  auto nodes = ownedNodes(mesh, condition.boundary);
  if (condition.meeting.empty()) {
    return nodes;
  }
  auto const others = ownedNodes(mesh, condition.meeting);
  std::vector<int> common;
  std::set_intersection(nodes.begin(), nodes.end(), others.begin(), others.end(),
                        std::back_inserter(common));
  return common;
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
    auto const& condition = conditions[i];
    auto const normals = normalsOf(condition, mesh, walls, components);
    for (int node : nodesOf(condition, mesh)) {
      auto direction = condition.direction.empty() ? normals.at(node) : condition.direction;
      ASPERITY_ASSERT(static_cast<int>(direction.size()) == components);
      normalise(direction, condition.name);
      if (condition.direction.empty() && condition.tangential) {
        direction = tangentOf(condition, direction);
      }
      result[node].push_back({direction, static_cast<int>(i)});
    }
  }
  return result;
}

template NodalDirections collectDirections(Mesh<2> const&, std::vector<VelocityCondition<2>> const&,
                                           int);
template NodalDirections collectDirections(Mesh<3> const&, std::vector<VelocityCondition<3>> const&,
                                           int);
} // namespace asperity::fem::detail
