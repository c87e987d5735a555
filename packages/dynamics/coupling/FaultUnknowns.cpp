#include "dynamics/coupling/FaultUnknowns.hpp"

#include "base/parallel/Reductions.hpp"

#include <cmath>

namespace asperity::dynamics
{
namespace
{
// scaled := values times scale
void multiply(ConstNodeView const& values, ConstNodeView const& scale, NodeView const& scaled)
{
  if (scale.extent(0) == 0) {
    Kokkos::deep_copy(scaled, values);
    return;
  }
  Kokkos::parallel_for(
    "asperity::dynamics::multiply", RangePolicy(0, scaled.extent(0)),
    KOKKOS_LAMBDA(int node) { scaled(node) = values(node) * scale(node); });
}

// values := scaled / scale
void divide(ConstNodeView const& scaled, ConstNodeView const& scale, NodeView const& values)
{
  if (scale.extent(0) == 0) {
    Kokkos::deep_copy(values, scaled);
    return;
  }
  Kokkos::parallel_for(
    "asperity::dynamics::divide", RangePolicy(0, values.extent(0)),
    KOKKOS_LAMBDA(int node) { values(node) = scaled(node) / scale(node); });
}

double largerOrNotFinite(double a, double b) { return !std::isfinite(a) || a > b ? a : b; }
} // namespace

FaultUnknowns::FaultUnknowns(fem::FaultSurface const& surface, int depth)
    : surface_(surface)
    , acceleration_(surface.weights(), surface.communicator(), depth)
{
}

void FaultUnknowns::add(std::shared_ptr<FaultUnknown> unknown)
{
  const int size = surface_.numNodes();
  entries_.push_back({std::move(unknown), NodeView("asperity::dynamics::image", size)});
  x_ = NodeView("asperity::dynamics::unknowns", entries_.size() * size);
  image_ = NodeView("asperity::dynamics::images", entries_.size() * size);
}

NodeView FaultUnknowns::part(NodeView const& all, std::size_t entry) const
{
  const std::size_t size = surface_.numNodes();
  return Kokkos::subview(all, std::make_pair(entry * size, (entry + 1) * size));
}

void FaultUnknowns::begin(StepStart const& start) const
{
  for (auto const& entry : entries_) {
    entry.unknown->begin(start);
  }
}

bool FaultUnknowns::respond(FaultResponse const& to)
{
  int failures = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    auto& [unknown, image] = entries_[i];
    failures += unknown->respond(to, image);
    multiply(unknown->of(to.to), unknown->scale(), part(x_, i));
    multiply(image, unknown->scale(), part(image_, i));
  }
  return sumOverRanks(failures, *surface_.communicator()) == 0;
}

double FaultUnknowns::change(Norm norm) const
{
  double largest = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    largest =
      largerOrNotFinite(dynamics::distance(surface_, part(image_, i), part(x_, i), norm), largest);
  }
  return largest;
}

void FaultUnknowns::advance(State& to)
{
  acceleration_.advance(x_, image_);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    auto const& unknown = *entries_[i].unknown;
    divide(part(x_, i), unknown.scale(), unknown.of(to));
    unknown.limit(unknown.of(to));
  }
}

void FaultUnknowns::finish(State& to) const
{
  for (auto const& [unknown, image] : entries_) {
    unknown->finish(image, to);
  }
}

void FaultUnknowns::complete(State const& from, double tau, State const& to) const
{
  for (auto const& entry : entries_) {
    entry.unknown->complete(from, tau, to);
  }
}

void FaultUnknowns::copyImages(State& to) const
{
  for (auto const& [unknown, image] : entries_) {
    Kokkos::deep_copy(unknown->of(to), image);
  }
}

double FaultUnknowns::distance(State const& a, State const& b, Norm norm) const
{
  double largest = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    auto const& unknown = *entries_[i].unknown;
    multiply(unknown.of(a), unknown.scale(), part(x_, i));
    multiply(unknown.of(b), unknown.scale(), part(image_, i));
    largest =
      largerOrNotFinite(dynamics::distance(surface_, part(x_, i), part(image_, i), norm), largest);
  }
  return largest;
}
} // namespace asperity::dynamics
