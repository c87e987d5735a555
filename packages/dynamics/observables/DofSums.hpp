#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

#include <Tpetra_Vector.hpp>

#include <utility>

namespace asperity::dynamics
{
// Values of a vector of owned dofs on the device: (num owned dofs, 1).
inline auto reading(Vector const& x) { return x.getLocalViewDevice(Tpetra::Access::ReadOnly); }
using DofValues = decltype(reading(std::declval<Vector const&>()));

// Sums of value(dof) over this rank's dofs, or over some of them.
template <class Value>
double sumOfAll(int num_dofs, Value const& value)
{
  double sum = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::sumOfAll", RangePolicy(0, num_dofs),
    KOKKOS_LAMBDA(int dof, double& part) { part += value(dof); }, sum);
  return sum;
}

template <class Value>
double sumAt(IndexView const& dofs, Value const& value)
{
  double sum = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::sumAt", RangePolicy(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int i, double& part) { part += value(dofs(i)); }, sum);
  return sum;
}
} // namespace asperity::dynamics
