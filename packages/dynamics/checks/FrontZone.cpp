#include "dynamics/checks/FrontZone.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "portability/Views.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace asperity::dynamics
{
FrontZone::FrontZone(std::vector<double> modulus, std::vector<double> const& b,
                     std::vector<double> const& L, std::vector<double> const& cell,
                     std::vector<bool> const& slides, RCP<const Communicator> communicator)
    : communicator_(std::move(communicator))
{
  std::vector<int> counts(L.size());
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t node = 0; node < L.size(); ++node) {
    counts[node] = slides[node] && b[node] > 0;
    if (counts[node]) {
      modulus[node] /= b[node];
      shortest = std::min(shortest, L[node]);
    }
  }
  shortest_ = minOverRanks(shortest, *communicator_);
  modulus_ = toDevice(modulus, "asperity::dynamics::modulusOverB");
  cell_ = toDevice(cell, "asperity::dynamics::largerCell");
  slides_ = toDevice(counts, "asperity::dynamics::slides");
}

// The slope of alpha along slip is that of the law's flow over a small slip, the same time for all
// nodes. Those that slip far more slowly than the fastest one would lose it to rounding.
std::optional<FrontZone::Narrowest>
FrontZone::narrowest(friction::StateKernels const& state, ConstNodeView const& V,
                     friction::StateAndStress const& given) const
{
  constexpr double small_slip = 1e-4; // of L
  constexpr double fast = 0.1;        // of the largest slip rate
  const double fastest = maxOverRanks(largestWhere(slides_, V), *communicator_);
  if (!(fastest > 0)) {
    return std::nullopt;
  }
  const double dt = small_slip * shortest_ / fastest;
  const int num_nodes = V.extent_int(0);
  const NodeView after("asperity::dynamics::alphaAfterSlip", num_nodes);
  state.flow(V, dt, given.alpha, after);

  auto const alpha = given.alpha, sigma_n = given.sigma_n;
  auto const slides = slides_;
  auto const modulus = modulus_, cell = cell_;
  constexpr double none = std::numeric_limits<double>::max();
  using Fewest = Kokkos::MinLoc<double, int>;
  Fewest::value_type mine;
  Kokkos::parallel_reduce(
    "asperity::dynamics::narrowestZone", RangePolicy(0, num_nodes),
    KOKKOS_LAMBDA(int node, Fewest::value_type& least) {
      const double weakening = (alpha(node) - after(node)) * sigma_n(node);
      if (slides(node) && V(node) >= fast * fastest && weakening > 0) {
        const double cells = modulus(node) * V(node) * dt / (weakening * cell(node));
        if (cells < least.val) {
          least.val = cells;
          least.loc = node;
        }
      }
    },
    Fewest(mine));
  const double fewest = minOverRanks(mine.val, *communicator_);
  if (fewest == none) {
    return std::nullopt;
  }
  Narrowest found{fewest, none, -1};
  if (mine.val == fewest) {
    found.node = mine.loc;
    double size = 0;
    Kokkos::deep_copy(size, Kokkos::subview(cell_, mine.loc));
    found.length = fewest * size;
  }
  found.length = minOverRanks(found.length, *communicator_);
  return found;
}
} // namespace asperity::dynamics
