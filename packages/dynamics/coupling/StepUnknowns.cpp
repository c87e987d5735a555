#include "dynamics/coupling/StepUnknowns.hpp"

#include "base/Errors.hpp"

#include <algorithm>
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
    KOKKOS_LAMBDA(int i) { scaled(i) = values(i) * scale(i); });
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
    KOKKOS_LAMBDA(int i) { values(i) = scaled(i) / scale(i); });
}

double largerOrNotFinite(double a, double b) { return !std::isfinite(a) || a > b ? a : b; }
} // namespace

StepUnknowns::Group::Group(UnknownSpace const& of_values, FollowsFrom motion_of_them, int depth)
    : space(of_values)
    , motion(motion_of_them)
    , acceleration(space.weights(), space.communicator(), depth)
{
}

void StepUnknowns::Group::add(std::shared_ptr<StepUnknown> unknown)
{
  const std::size_t size = space.weights().extent(0);
  entries.push_back({std::move(unknown), NodeView("asperity::dynamics::image", size)});
  x = NodeView("asperity::dynamics::unknowns", entries.size() * size);
  images = NodeView("asperity::dynamics::images", entries.size() * size);
}

NodeView StepUnknowns::Group::part(NodeView const& all, std::size_t entry) const
{
  const std::size_t size = all.extent(0) / entries.size();
  return Kokkos::subview(all, std::make_pair(entry * size, (entry + 1) * size));
}

void StepUnknowns::Group::begin()
{
  acceleration.reset();
  is_updated = false;
  change = ratio = 0;
  last_advanced = std::numeric_limits<double>::infinity();
}

double StepUnknowns::Group::updateImages(StepIterate const& step, Norm norm)
{
  double now = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto& [unknown, image] = entries[i];
    const int failures = unknown->respond(step, image);
    multiply(unknown->valuesIn(step.to), unknown->scale(), part(x, i));
    multiply(image, unknown->scale(), part(images, i));
    if (failures > 0) { // so that all ranks find no finite distance
      Kokkos::deep_copy(part(images, i), std::numeric_limits<double>::infinity());
    }
    now = largerOrNotFinite(space.distance(part(images, i), part(x, i), norm), now);
  }
  ratio = change > 0 ? now / change : 0;
  change = now;
  is_updated = true;
  return now;
}

bool StepUnknowns::Group::advance(State const& to)
{
  if (change > last_advanced) {
    acceleration.reset();
  }
  last_advanced = change;
  acceleration.advance(x, images);
  bool forces_change = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto const& unknown = *entries[i].unknown;
    auto const values = unknown.valuesIn(to);
    divide(part(x, i), unknown.scale(), values);
    unknown.limit(values);
    forces_change |= unknown.addsForces();
  }
  return forces_change;
}

double StepUnknowns::Group::distance(State const& a, State const& b, Norm norm) const
{
  double largest = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto const& unknown = *entries[i].unknown;
    multiply(unknown.valuesIn(a), unknown.scale(), part(x, i));
    multiply(unknown.valuesIn(b), unknown.scale(), part(images, i));
    largest = largerOrNotFinite(space.distance(part(x, i), part(images, i), norm), largest);
  }
  return largest;
}

StepUnknowns::StepUnknowns(fem::FaultSurface const& surface, int depth, StepUnknownList unknowns)
    : unknowns_(std::move(unknowns))
    , nodes_(surface)
{
  for (auto const& unknown : unknowns_) {
    auto const motion = unknown->followsFrom();
    if (motion == FollowsFrom::start) {
      continue;
    }
    auto const& space = unknown->space() != nullptr ? *unknown->space() : nodes_;
    auto group = std::find_if(groups_.begin(), groups_.end(), [&](Group const& other) {
      return &other.space == &space && other.motion == motion;
    });
    if (group == groups_.end()) {
      group = groups_.emplace(groups_.end(), space, motion, depth);
    }
    group->add(unknown);
  }
}

bool StepUnknowns::followFromBody() const
{
  return std::any_of(groups_.begin(), groups_.end(),
                     [](Group const& group) { return group.motion == FollowsFrom::body; });
}

bool StepUnknowns::addForces() const
{
  return std::any_of(unknowns_.begin(), unknowns_.end(),
                     [](auto const& unknown) { return unknown->addsForces(); });
}

std::shared_ptr<const NormalReaction> StepUnknowns::reaction() const
{
  std::shared_ptr<const NormalReaction> needed;
  for (auto const& unknown : unknowns_) {
    auto const reaction = unknown->reaction();
    ASPERITY_ASSERT(!reaction || !needed || reaction == needed); // solvers know one
    needed = reaction ? reaction : needed;
  }
  return needed;
}

void StepUnknowns::evaluate(double t0, double t1) const
{
  for (auto const& unknown : unknowns_) {
    unknown->evaluate(t0, t1);
  }
}

void StepUnknowns::begin(StepStart const& start)
{
  for (auto& group : groups_) {
    group.begin();
  }
  for (auto const& unknown : unknowns_) {
    unknown->begin(start);
  }
}

void StepUnknowns::addForces(State const& to, Vector& b) const
{
  for (auto const& unknown : unknowns_) {
    if (unknown->addsForces()) {
      unknown->addForces(to, b);
    }
  }
}

void StepUnknowns::setRightSide(Vector const& b) const
{
  for (auto const& unknown : unknowns_) {
    unknown->setRightSide(b);
  }
}

double StepUnknowns::updateImages(FollowsFrom motion, StepIterate const& step, Norm norm)
{
  double largest = 0;
  for (auto& group : groups_) {
    if (group.motion == motion) {
      largest = largerOrNotFinite(group.updateImages(step, norm), largest);
    } else if (motion == FollowsFrom::fault) {
      group.is_updated = false;
    }
  }
  return largest;
}

bool StepUnknowns::bodyIsDue(double of_fault, bool rate_converged, double tolerance) const
{
  const bool fault_converged = rate_converged && of_fault <= tolerance;
  return std::any_of(groups_.begin(), groups_.end(), [&](Group const& group) {
    const double expected = group.change * group.ratio;
    return group.motion == FollowsFrom::body &&
           (fault_converged || (of_fault <= group.change && expected > tolerance));
  });
}

bool StepUnknowns::advance(State const& to)
{
  bool forces_change = false;
  for (auto& group : groups_) {
    if (group.is_updated) {
      forces_change |= group.advance(to);
    }
  }
  return forces_change;
}

void StepUnknowns::finish(State const& to) const
{
  for (auto const& group : groups_) {
    for (auto const& [unknown, image] : group.entries) {
      unknown->finish(image, to);
    }
  }
}

void StepUnknowns::complete(State const& from, double tau, State const& to) const
{
  for (auto const& unknown : unknowns_) {
    unknown->complete(from, tau, to);
  }
}

void StepUnknowns::copyImages(State const& to) const
{
  for (auto const& group : groups_) {
    for (auto const& [unknown, image] : group.entries) {
      Kokkos::deep_copy(unknown->valuesIn(to), image);
    }
  }
}

double StepUnknowns::distance(State const& a, State const& b, Norm norm) const
{
  double largest = 0;
  for (auto const& group : groups_) {
    largest = largerOrNotFinite(group.distance(a, b, norm), largest);
  }
  return largest;
}
} // namespace asperity::dynamics
