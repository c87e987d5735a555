#include "scenario/setup/conditions/FreeFault.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity::scenario
{
namespace
{
using Vectors = std::vector<std::vector<double>>;

// The smallest part of a unit vector at right angles to others that counts as a direction of its
// own. Smaller ones are rounding, or the bend of a fault within a facet.
constexpr double smallest_part = 1e-6;

// Adds the part of a unit vector that is at right angles to the others, scaled to length 1.
void addDirection(Vectors& others, std::vector<double> direction)
{
  const auto product = [](auto const& a, auto const& b) {
    double sum = 0;
    for (std::size_t c = 0; c < a.size(); ++c) {
      sum += a[c] * b[c];
    }
    return sum;
  };
  for (auto const& other : others) {
    const double part = product(direction, other);
    for (std::size_t c = 0; c < other.size(); ++c) {
      direction[c] -= part * other[c];
    }
  }
  const double size = std::sqrt(product(direction, direction));
  if (size > smallest_part) {
    for (double& component : direction) {
      component /= size;
    }
    others.push_back(direction);
  }
}

template <int Dim>
typename Mesh<Dim>::Facet sorted(typename Mesh<Dim>::Facet facet)
{
  std::sort(facet.begin(), facet.end());
  return facet;
}

template <int Dim>
class FacetsOfFault
{
public:
  FacetsOfFault(std::string const& fault, Mesh<Dim> const& mesh, int components)
      : fault_(fault)
      , mesh_(mesh)
      , components_(components)
  {
    for (auto const& facet : mesh.boundaries.at(fault)) {
      auto const normal = normalOf(facet);
      held_[sorted<Dim>(facet)] = components == 1 ? Vectors() : Vectors(1, normal);
    }
  }

  void add(fem::VelocityCondition<Dim> const& condition)
  {
    for (auto const& facet : mesh_.boundaries.at(condition.boundary)) {
      auto const found = held_.find(sorted<Dim>(facet));
      if (found == held_.end()) {
        continue;
      }
      auto const normal = normalOf(facet);
      addDirection(found->second,
                   components_ == 1 ? std::vector<double>{1} : condition.unitDirection(normal));
      ASPERITY_REQUIRE(
        static_cast<int>(found->second.size()) < components_,
        condition.name << " (boundary '" << condition.boundary
                       << "') prescribes the velocity along the fault '" << fault_
                       << "', as at x = " << mesh::text(mesh::centroid(mesh::corners(mesh_, facet)))
                       << ", where friction has to determine it. Give the condition another "
                          "boundary; where the fault's continuation slips at a given rate, "
                          "choose the Type '"
                       << continuationType().name << "' instead of the fault's.");
    }
  }

private:
  std::vector<double> normalOf(typename Mesh<Dim>::Facet const& facet) const
  {
    auto const normal = mesh::facetNormal(mesh::corners(mesh_, facet));
    return {normal.begin(), normal.end()};
  }

  std::string const& fault_;
  Mesh<Dim> const& mesh_;
  int components_;
  std::map<typename Mesh<Dim>::Facet, Vectors> held_; // orthonormal, the normal first
};
} // namespace

template <int Dim>
void requireFreeFault(BoundaryConditions<Dim> const& boundary, Mesh<Dim> const& mesh,
                      int components, Communicator const& communicator)
{
  onEveryRank(communicator, [&] {
    for (auto const& fault : boundary.faults) {
      auto const& given = boundary.given_slip;
      if (std::find(given.begin(), given.end(), fault) != given.end()) {
        continue;
      }
      FacetsOfFault<Dim> facets(fault, mesh, components);
      for (auto const& condition : boundary.velocities) {
        if (condition.prescribes()) {
          facets.add(condition);
        }
      }
    }
  });
}

template void requireFreeFault(BoundaryConditions<2> const&, Mesh<2> const&, int,
                               Communicator const&);
template void requireFreeFault(BoundaryConditions<3> const&, Mesh<3> const&, int,
                               Communicator const&);
} // namespace asperity::scenario
