#include "dynamics/control/NotFinite.hpp"

#include <limits>

namespace asperity::dynamics
{
namespace
{
KOKKOS_INLINE_FUNCTION bool hasFiniteSquare(double x)
{
  return x * x <= std::numeric_limits<double>::max();
}

// Whether all values have a finite square. Counts those that do not, because sums of integers are
// faster on the device than sums of floating-point numbers.
bool haveFiniteSquares(Kokkos::View<const double*, MemorySpace> const& values)
{
  int others = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::haveFiniteSquares",
    Kokkos::RangePolicy<ExecutionSpace>(0, values.extent_int(0)),
    KOKKOS_LAMBDA(int i, int& partial) { partial += hasFiniteSquare(values(i)) ? 0 : 1; }, others);
  return others == 0;
}

std::optional<NotFinite> lookIn(char const* field, bool at_fault,
                                Kokkos::View<const double*, MemorySpace> const& values)
{
  if (haveFiniteSquares(values)) {
    return std::nullopt;
  }
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), values);
  int i = 0;
  while (i < host.extent_int(0) && hasFiniteSquare(host(i))) {
    ++i;
  }
  return i < host.extent_int(0) ? std::optional<NotFinite>({field, at_fault, i, host(i)})
                                : std::nullopt;
}

std::optional<NotFinite> lookIn(char const* field, Vector const& x)
{
  auto const view = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
  return lookIn(field, false,
                Kokkos::View<const double*, MemorySpace>(view.data(), view.extent(0)));
}
} // namespace

std::optional<NotFinite> firstNotFinite(State const& state)
{
  auto found = lookIn("velocity", *state.v);
  found = found ? found : lookIn("displacement", *state.u);
  found = found ? found : lookIn("acceleration", *state.a);
  found = found ? found : lookIn("alpha", true, state.alpha);
  return found ? found : lookIn("normal stress", true, state.sigma_n);
}

std::optional<NotFinite> firstNotFiniteAtFault(State const& state)
{
  auto found = lookIn("velocity", *state.v);
  found = found ? found : lookIn("alpha", true, state.alpha);
  return found ? found : lookIn("normal stress", true, state.sigma_n);
}

std::optional<NotFinite> firstNotFinite(char const* field, Vector const& x)
{
  return lookIn(field, x);
}
} // namespace asperity::dynamics
