#include "fem/constraints/detail/VelocityAgreement.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/PointText.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem::detail
{
template <int Dim>
VelocityAgreement<Dim>::VelocityAgreement(Mesh<Dim> const& mesh,
                                          std::vector<VelocityCondition<Dim>> const& conditions,
                                          std::vector<double> const& sample_times,
                                          NodalDirections const& directions,
                                          Communicator const& communicator)
    : mesh_(mesh)
    , conditions_(conditions)
    , sample_times_(sample_times)
{
  std::vector<double> mine(conditions.size(), 0.);
  for (auto const& [node, of_node] : directions) {
    for (auto const& direction : of_node) {
      auto const& condition = conditions[direction.condition];
      auto& largest = mine[direction.condition];
      for (double t : sample_times) {
        largest = std::max(largest, std::abs(condition.velocity(mesh.vertices[node], t)));
      }
    }
  }
  largest_ = maxOverRanks(mine, communicator);
}

template <int Dim>
void VelocityAgreement<Dim>::require(int node, int condition, Terms const& difference) const
{
  constexpr double tolerance = 1e-10;
  auto const& x = mesh_.vertices[node];
  int contradicted = condition;
  for (auto const& [other, coefficient] : difference) {
    contradicted = other != condition ? other : contradicted;
  }
  auto const &one = conditions_[condition], &other = conditions_[contradicted];
  for (double t : sample_times_) {
    double sum = 0;
    double scale = 0;
    for (auto const& [number, coefficient] : difference) {
      sum += coefficient * conditions_[number].velocity(x, t);
      scale = std::max(scale, std::abs(coefficient) * largest_[number]);
    }
    ASPERITY_REQUIRE(std::abs(sum) <= tolerance * scale,
                     one.name << " (boundary '" << one.boundary << "') contradicts " << other.name
                              << " (boundary '" << other.boundary << "') at "
                              << "x = " << mesh::text(x) << ", t = " << t
                              << " s: both prescribe the velocity in the same direction, and the "
                                 "values differ by "
                              << sum << " m/s. Remove one of them.");
  }
}

template class VelocityAgreement<2>;
template class VelocityAgreement<3>;
} // namespace asperity::fem::detail
