#include "dynamics/control/NotFinite.hpp"

#include "fem/inelastic/InelasticCells.hpp"

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

// width: the number of values that belong to each index of the place
std::optional<NotFinite> searchField(std::string const& quantity, NotFinite::Place place,
                                     ConstNodeView const& values, int width = 1)
{
  if (haveFiniteSquares(values)) {
    return std::nullopt;
  }
  auto const host = toHost(values);
  int i = 0;
  while (i < host.extent_int(0) && hasFiniteSquare(host(i))) {
    ++i;
  }
  return i < host.extent_int(0) ? std::optional<NotFinite>({quantity, place, i / width, host(i)})
                                : std::nullopt;
}

enum class Fields
{
  all,
  guessed // FieldInfo::is_guessed
};

std::optional<NotFinite> searchState(State const& state, Fields fields)
{
  using Place = NotFinite::Place;
  std::optional<NotFinite> found;
  const auto look = [&](FieldInfo const& info, Place place, auto const& field, int width = 1) {
    if (!found && (info.is_guessed || fields == Fields::all)) {
      found = searchField(info.quantity, place, valuesOf(field), width);
    }
  };
  State::visitBody(
    [&](FieldInfo const& info, auto const& field) { look(info, Place::body, field); }, state);
  State::visitFault(
    [&](FieldInfo const& info, auto const& field) { look(info, Place::fault, field); }, state);
  State::visitCells([&](FieldInfo const& info,
                        auto const& field) { look(info, Place::cell, field, field.extent_int(1)); },
                    state);
  return found;
}
} // namespace

std::optional<NotFinite> firstNotFinite(State const& state)
{
  return searchState(state, Fields::all);
}

std::optional<NotFinite> firstNotFiniteAtFault(State const& state)
{
  return searchState(state, Fields::guessed);
}

std::optional<NotFinite> firstNotFinite(std::string const& quantity, RCP<Vector> const& x)
{
  return searchField(quantity, NotFinite::Place::body, valuesOf(x));
}

int NotFinite::vertexIn(Body const& body, fem::FaultSurface const& surface) const
{
  switch (place) {
  case Place::fault: return surface.vertex(index);
  case Place::cell: return body.cells->vertexOf(index);
  default: return index / body.dofs->components();
  }
}
} // namespace asperity::dynamics
