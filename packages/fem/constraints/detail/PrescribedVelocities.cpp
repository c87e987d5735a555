#include "fem/constraints/detail/PrescribedVelocities.hpp"

#include "base/Views.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <utility>

namespace asperity::fem::detail
{
namespace
{
// x(dofs) := values
void set(Vector& x, IndexView const& dofs, ConstNodeView const& values)
{
  auto const target = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::fem::prescribe", RangePolicy(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int k) { target(dofs(k), 0) = values(k); });
}
} // namespace

template <int Dim>
PrescribedVelocities<Dim>::PrescribedVelocities(std::vector<VelocityCondition<Dim>> conditions,
                                                std::vector<PrescribedDof<Dim>> const& dofs)
    : conditions_(std::move(conditions))
{
  std::vector<int> constant;
  std::vector<double> velocities;
  for (auto const& dof : dofs) {
    if (dependsOnTime(dof)) {
      varying_.push_back(dof);
    } else {
      constant.push_back(dof.dof);
      velocities.push_back(velocity(dof, 0));
    }
  }
  varying_dofs_ = toDevice(dofsThatVary(), "asperity::fem::dofsThatVary");
  constant_dofs_ = toDevice(constant, "asperity::fem::constantDofs");
  constant_velocities_ = toDevice(velocities, "asperity::fem::constantVelocities");
}

template <int Dim>
void PrescribedVelocities<Dim>::at(double t, Vector& v) const
{
  std::vector<double> values;
  for (auto const& dof : varying_) {
    values.push_back(velocity(dof, t));
  }
  v.putScalar(0);
  set(v, constant_dofs_, constant_velocities_);
  set(v, varying_dofs_, toDevice(values, "asperity::fem::prescribedValues"));
}

template <int Dim>
std::vector<int> PrescribedVelocities<Dim>::dofsThatVary() const
{
  std::vector<int> result;
  for (auto const& dof : varying_) {
    result.push_back(dof.dof);
  }
  return result;
}

template <int Dim>
bool PrescribedVelocities<Dim>::dependsOnTime(PrescribedDof<Dim> const& dof) const
{
  return std::any_of(dof.terms.begin(), dof.terms.end(),
                     [&](auto const& term) { return conditions_[term.first].dependsOnTime(); });
}

template <int Dim>
double PrescribedVelocities<Dim>::velocity(PrescribedDof<Dim> const& dof, double t) const
{
  double sum = 0;
  for (auto const& [condition, coefficient] : dof.terms) {
    sum += coefficient * conditions_[condition].velocity(dof.place, t);
  }
  return sum;
}

template class PrescribedVelocities<2>;
template class PrescribedVelocities<3>;
} // namespace asperity::fem::detail
