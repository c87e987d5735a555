#include "scenario/fields/FloorCount.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>

namespace asperity::scenario
{
FloorCount::FloorCount(dynamics::Fault const& fault) : fault_(fault)
{
  auto const& surface = fault.surface();
  double mine = 0;
  for (int node = 0; node < surface.numNodes(); ++node) {
    mine += surface.slides(node) ? surface[node].weight : 0;
  }
  sliding_ = sumOverRanks(mine, *surface.communicator());
}

bool FloorCount::matters() const
{
  auto const& stress = fault_.normalStress();
  return stress.change() != dynamics::NormalStressChange::fixed || stress.floor() > 0;
}

void FloorCount::add(dynamics::State const& now)
{
  if (!matters()) {
    return;
  }
  auto const& surface = fault_.surface();
  const double floor = fault_.normalStress().floor();
  const ConstNodeView sigma_n = now.sigma_n, weights = surface.weights();
  auto const slides = surface.slidingNodes();
  double weight = 0;
  std::int64_t nodes = 0;
  Kokkos::parallel_reduce(
    "asperity::scenario::onFloor", RangePolicy(0, surface.numNodes()),
    KOKKOS_LAMBDA(int node, double& measure, std::int64_t& count) {
      if (slides(node) && sigma_n(node) <= floor) {
        measure += weights(node);
        ++count;
      }
    },
    weight, nodes);
  auto const& communicator = *surface.communicator();
  node_steps_ += sumOverRanks(nodes, communicator);
  const double on_floor = sumOverRanks(weight, communicator);
  share_ = sliding_ > 0 ? on_floor / sliding_ : 0;
  largest_share_ = std::max(largest_share_, share_);
}

std::string FloorCount::report() const
{
  if (!matters()) {
    return "";
  }
  auto const floor = formatShort(fault_.normalStress().floor());
  if (node_steps_ == 0) {
    return "The normal stress stayed above its floor of " + floor + " Pa.\n";
  }
  return "The normal stress was on its floor of " + floor + " Pa at " +
         counted(node_steps_, "node") + " in the sum over all steps, on at most " +
         formatShort(100 * largest_share_) + " % of the fault at a time.\n";
}

void FloorCount::save(Archive& archive) const
{
  if (matters()) {
    archive.set("share", share_);
    archive.set("largest_share", largest_share_);
    archive.set("node_steps", node_steps_);
  }
}

void FloorCount::restore(Archive const& archive)
{
  if (matters()) {
    share_ = archive.getDouble("share");
    largest_share_ = archive.getDouble("largest_share");
    node_steps_ = archive.getInteger("node_steps");
  }
}
} // namespace asperity::scenario
