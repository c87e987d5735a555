#include "dynamics/control/NotFinite.hpp"

#include <cmath>

namespace asperity::dynamics
{
namespace
{
template <class View>
int firstIn(View const& host, std::size_t size)
{
  // The product with zero is zero for finite numbers alone, which a loop without branches adds up.
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) {
    sum += 0 * host[i];
  }
  if (sum == 0) {
    return -1;
  }
  std::size_t i = 0;
  while (i < size && std::isfinite(host[i])) {
    ++i;
  }
  return i < size ? static_cast<int>(i) : -1;
}

std::optional<NotFinite> lookIn(char const* field, Vector const& x)
{
  auto const view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  const int found = firstIn(view.data(), view.extent(0));
  return found < 0 ? std::nullopt
                   : std::optional<NotFinite>({field, false, found, view.data()[found]});
}

std::optional<NotFinite> lookIn(char const* field, friction::NodeView const& x)
{
  auto const view = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), x);
  const int found = firstIn(view.data(), view.extent(0));
  return found < 0 ? std::nullopt
                   : std::optional<NotFinite>({field, true, found, view.data()[found]});
}
} // namespace

std::optional<NotFinite> firstNotFinite(State const& state)
{
  auto found = lookIn("velocity", *state.v);
  found = found ? found : lookIn("displacement", *state.u);
  found = found ? found : lookIn("acceleration", *state.a);
  found = found ? found : lookIn("alpha", state.alpha);
  return found ? found : lookIn("normal stress", state.sigma_n);
}

std::optional<NotFinite> firstNotFinite(char const* field, Vector const& x)
{
  return lookIn(field, x);
}
} // namespace asperity::dynamics
