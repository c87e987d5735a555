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
bool haveFiniteSquares(ConstNodeView const& values)
{
  int others = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::haveFiniteSquares", RangePolicy(0, values.extent_int(0)),
    KOKKOS_LAMBDA(int i, int& partial) { partial += hasFiniteSquare(values(i)) ? 0 : 1; }, others);
  return others == 0;
}

std::optional<NotFinite> lookIn(std::string const& quantity, bool at_fault,
                                ConstNodeView const& values)
{
  if (haveFiniteSquares(values)) {
    return std::nullopt;
  }
  auto const host = toHost(values);
  int i = 0;
  while (i < host.extent_int(0) && hasFiniteSquare(host(i))) {
    ++i;
  }
  return i < host.extent_int(0) ? std::optional<NotFinite>({quantity, at_fault, i, host(i)})
                                : std::nullopt;
}

std::optional<NotFinite> lookIn(State const& state, bool among_guessed_alone)
{
  std::optional<NotFinite> found;
  bool at_fault = false;
  const auto look = [&](FieldInfo const& info, auto const& field) {
    if (!found && (info.is_guessed || !among_guessed_alone)) {
      found = lookIn(info.quantity, at_fault, valuesOf(field));
    }
  };
  State::visitBody(look, state);
  at_fault = true;
  State::visitFault(look, state);
  return found;
}
} // namespace

std::optional<NotFinite> firstNotFinite(State const& state) { return lookIn(state, false); }

std::optional<NotFinite> firstNotFiniteAtFault(State const& state) { return lookIn(state, true); }

std::optional<NotFinite> firstNotFinite(std::string const& quantity, RCP<Vector> const& x)
{
  return lookIn(quantity, false, valuesOf(x));
}
} // namespace asperity::dynamics
