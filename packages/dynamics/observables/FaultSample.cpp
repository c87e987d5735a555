#include "dynamics/observables/FaultSample.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "dynamics/fault/OpeningForces.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
namespace
{
template <class Value, class Compute>
Value const& once(std::optional<Value>& known, Compute const& compute)
{
  if (!known) {
    known = compute();
  }
  return *known;
}

BlockView blocksOf(fem::FaultSurface const& surface)
{
  return BlockView("asperity::dynamics::blocks", surface.numNodes(), surface.numTangents());
}
} // namespace

FaultSample::FaultSample(fem::FaultSurface const& surface, Vector const& start)
    : surface_(surface)
    , start_(blocksOf(surface))
{
  gather(surface, start, start_);
}

void FaultSample::begin(State const& state, double time, EnergyBalance const& balance)
{
  state_ = &state;
  time_ = time;
  balance_ = &balance;
  known_ = {};
}

int FaultSample::numComponents() const
{
  return surface_.numTangents() == 1 ? 1 : surface_.numTangents() + 1;
}

ConstNodeView FaultSample::slipRates() const
{
  return once(known_.V, [this] {
    const NodeView V("asperity::dynamics::slipRate", surface_.numNodes());
    dynamics::slipRate(surface_, balance_->slipVelocity(), V);
    return V;
  });
}

// blocks(num_nodes, T): along the tangents; factor(node) multiplies those of a node.
template <class Factor>
FaultSample::Values FaultSample::written(ConstBlockView const& blocks, Factor const& factor) const
{
  auto const host = toHost(blocks);
  const int components = numComponents();
  Values result(static_cast<std::size_t>(surface_.numNodes()) * components, 0.);
  for (int node = 0; node < surface_.numNodes(); ++node) {
    for (int k = 0; k < surface_.numTangents(); ++k) {
      const double value = factor(node) * host(node, k);
      for (int c = 0; c < components; ++c) {
        double& sum = result[node * components + c];
        sum = components == 1 ? value : sum + surface_[node].tangents[k][c] * value;
      }
    }
  }
  return result;
}

FaultSample::Values const& FaultSample::slipRate() const
{
  return once(known_.slip_rate, [this] { return toVector(slipRates()); });
}

double FaultSample::peakSlipRate() const
{
  return once(known_.peak, [this] { return dynamics::peakSlipRate(surface_, slipRates()); });
}

FaultSample::Values const& FaultSample::alpha() const
{
  return once(known_.alpha, [this] { return toVector(state_->alpha); });
}

FaultSample::Values const& FaultSample::normalStress() const
{
  return once(known_.normal_stress, [this] { return toVector(state_->sigma_n); });
}

FaultSample::Values const& FaultSample::effectiveStress() const
{
  return once(known_.effective_stress,
              [this] { return toVector(balance_->fault().effectiveStress(*state_)); });
}

FaultSample::Values const& FaultSample::slip() const
{
  return once(known_.slip, [this] {
    auto const blocks = blocksOf(surface_);
    gatherSlipSince(surface_, start_, *state_->u, time_, blocks);
    return written(blocks, [this](int) { return surface_.slipFactor(); });
  });
}

FaultSample::Values const& FaultSample::slipVelocity() const
{
  return once(known_.slip_velocity, [this] {
    return written(balance_->slipVelocity(), [this](int) { return surface_.slipFactor(); });
  });
}

FaultSample::Values const& FaultSample::opening() const
{
  return once(known_.opening, [this] { return toVector(openingOf(surface_, *state_->u)); });
}

// A fault that is shut has an opening of rounding, of either sign, and an open one bears a stress
// of rounding. The opening tells them apart: it is an unknown itself, and is rounded by far less
// than displacements are.
double FaultSample::shareOpen() const
{
  constexpr double rounding = 1e-10;
  auto const& open = opening();
  const double least = rounding * state_->u->normInf();
  double mine = 0;
  for (int node = 0; node < surface_.numNodes(); ++node) {
    mine += open[node] > least ? surface_[node].weight : 0;
  }
  return sumOverRanks(mine, *surface_.communicator()) / surface_.totalWeight();
}

FaultSample::Values const& FaultSample::traction() const
{
  return once(known_.traction, [this] {
    auto const blocks = blocksOf(surface_);
    gather(surface_, balance_->force(), blocks);
    return written(blocks, [this](int node) { return 1 / surface_[node].weight; });
  });
}
} // namespace asperity::dynamics
