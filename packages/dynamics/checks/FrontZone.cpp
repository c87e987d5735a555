#include "dynamics/checks/FrontZone.hpp"

#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace asperity::dynamics
{
FrontZone::FrontZone(std::vector<double> const& slip_modulus, std::vector<double> const& b,
                     std::vector<double> const& L, std::vector<double> cell,
                     std::vector<bool> slides, RCP<const Communicator> communicator)
    : modulus_(slip_modulus)
    , L_(L)
    , cell_(std::move(cell))
    , slides_(std::move(slides))
    , communicator_(std::move(communicator))
{
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t node = 0; node < L.size(); ++node) {
    slides_[node] = slides_[node] && b[node] > 0;
    if (slides_[node]) {
      modulus_[node] /= b[node];
      shortest = std::min(shortest, L[node]);
    }
  }
  shortest_ = minOverRanks(shortest, *communicator_);
}

// The slope of alpha along slip is that of the law's flow over a small slip, the same time for all
// nodes. Those that slip far more slowly than the fastest one would lose it to rounding.
std::optional<FrontZone::Narrowest>
FrontZone::narrowest(friction::StateKernels const& state, ConstNodeView const& V,
                     friction::StateAndStress const& given) const
{
  constexpr double small_slip = 1e-4; // of L
  constexpr double fast = 0.1;        // of the largest slip rate
  auto const rates = toVector(V);
  double fastest = 0;
  for (std::size_t node = 0; node < rates.size(); ++node) {
    fastest = slides_[node] ? std::max(fastest, rates[node]) : fastest;
  }
  fastest = maxOverRanks(fastest, *communicator_);
  if (!(fastest > 0)) {
    return std::nullopt;
  }
  const double dt = small_slip * shortest_ / fastest;
  const NodeView after("asperity::dynamics::alphaAfterSlip", rates.size());
  state.flow(V, dt, given.alpha, after);
  auto const alpha = toVector(given.alpha), sigma_n = toVector(given.sigma_n);
  auto const changed = toVector(after);
  constexpr double none = std::numeric_limits<double>::max();
  Narrowest found{none, none, -1};
  for (std::size_t node = 0; node < rates.size(); ++node) {
    const double fall = alpha[node] - changed[node];
    if (!slides_[node] || rates[node] < fast * fastest || !(fall * sigma_n[node] > 0)) {
      continue;
    }
    const double length = modulus_[node] * rates[node] * dt / (fall * sigma_n[node]);
    if (length / cell_[node] < found.cells) {
      found = {length / cell_[node], length, static_cast<int>(node)};
    }
  }
  const double fewest = minOverRanks(found.cells, *communicator_);
  if (fewest == none) {
    return std::nullopt;
  }
  const bool is_here = found.cells == fewest;
  return Narrowest{fewest, minOverRanks(is_here ? found.length : none, *communicator_),
                   is_here ? found.node : -1};
}
} // namespace asperity::dynamics
