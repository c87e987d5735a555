#pragma once

#include "dynamics/coupling/AndersonAcceleration.hpp"
#include "dynamics/coupling/FaultUnknown.hpp"
#include "dynamics/fault/FaultMotion.hpp"

#include <memory>
#include <vector>

namespace asperity::dynamics
{
// The unknowns of a step's fixed point, all together: x is the list of their present iterates, all
// nodes of the first unknown first and each times its scale, g(x) that of their images.
class FaultUnknowns
{
public:
  // depth: of the acceleration, see AndersonAcceleration. surface must outlive this.
  FaultUnknowns(fem::FaultSurface const& surface, int depth);
  void add(std::shared_ptr<FaultUnknown> unknown);

  // Prepares for a step. Collective.
  void begin(StepStart const& start) const;
  // Forgets the iterates of the step before, or those that point away from the fixed point.
  void restart() { acceleration_.reset(); }
  // Computes the images. False if an unknown has none at some node, on any rank. Collective.
  bool respond(FaultResponse const& to);
  // |g(x) - x|, the largest of all unknowns; not finite if a value is not. Collective.
  double change(Norm norm) const;
  // The next iterates in `to`. Collective.
  void advance(State& to);
  // Ends the fixed point: the final values in `to`, see FaultUnknown.
  void finish(State& to) const;
  // Sets what follows from the unknowns at the end of that step, see FaultUnknown.
  void complete(State const& from, double tau, State const& to) const;
  // All images in `to`.
  void copyImages(State& to) const;

  // The error of a step that ends in a, if b is its exact end: the largest of the unknowns, each
  // times its scale in the last step. Between steps. Collective.
  double distance(State const& a, State const& b, Norm norm) const;

private:
  struct Entry
  {
    std::shared_ptr<FaultUnknown> unknown;
    NodeView image;
  };
  NodeView part(NodeView const& all, std::size_t entry) const;

  fem::FaultSurface const& surface_;
  AndersonAcceleration acceleration_;
  std::vector<Entry> entries_;
  NodeView x_, image_; // (num_unknowns num_nodes)
};
} // namespace asperity::dynamics
