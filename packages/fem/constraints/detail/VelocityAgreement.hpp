#pragma once

#include "base/Types.hpp"
#include "fem/constraints/VelocityCondition.hpp"
#include "fem/constraints/detail/ConditionDirections.hpp"

#include <vector>

namespace asperity::fem::detail
{
// Whether conditions that prescribe the velocity along one direction prescribe the same velocity.
// Refers to the first three arguments of its constructor, which must outlive it.
template <int Dim>
class VelocityAgreement
{
public:
  // directions: those of all conditions at the owned nodes. sample_times: at which velocities are
  // compared [s]. Collective.
  VelocityAgreement(Mesh<Dim> const& mesh, std::vector<VelocityCondition<Dim>> const& conditions,
                    std::vector<double> const& sample_times, NodalDirections const& directions,
                    Communicator const& communicator);

  // `difference` is what NodalBasis::add leaves of the velocity of a condition at an owned node
  // whose direction depends on those before. Throws InputError, which names the condition and one
  // that it contradicts, unless the difference is zero, to 1e-10 of the largest velocity that the
  // conditions prescribe anywhere. Not collective.
  void require(int node, int condition, Terms const& difference) const;

private:
  Mesh<Dim> const& mesh_;
  std::vector<VelocityCondition<Dim>> const& conditions_;
  std::vector<double> const& sample_times_;
  // (num_conditions) the largest velocity of each at the sample times, over all ranks [m/s]. This
  // is the scale of differences: at a corner the velocity itself may be zero up to rounding.
  std::vector<double> largest_;
};
} // namespace asperity::fem::detail
