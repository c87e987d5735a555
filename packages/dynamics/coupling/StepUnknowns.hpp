#pragma once

#include "dynamics/coupling/AndersonAcceleration.hpp"
#include "dynamics/coupling/StepUnknown.hpp"
#include "dynamics/fault/FaultMotion.hpp"

#include <limits>
#include <list>

namespace asperity::dynamics
{
// The unknowns of a step's fixed point, all together. Those of one space that follow from the same
// motion are accelerated together: x is the list of their present iterates, all values of the first
// unknown first and each times its scale, g(x) that of their images.
class StepUnknowns
{
public:
  // depth: of the acceleration, see AndersonAcceleration. surface must outlive this.
  StepUnknowns(fem::FaultSurface const& surface, int depth, StepUnknownList unknowns);
  StepUnknowns(StepUnknowns const&) = delete; // parts refer to others
  StepUnknowns& operator=(StepUnknowns const&) = delete;

  bool followFromBody() const; // whether any does
  bool addForces() const;
  std::shared_ptr<const NormalReaction> reaction() const; // that one of them needs, or null

  // These open a step, as those of StepUnknown do.
  void evaluate(double t0, double t1) const;
  void begin(StepStart const& start);
  void addForces(State const& to, Vector& b) const;
  void setRightSide(Vector const& b) const;

  // Computes the images of those that follow from the fault, or of those that follow from the body.
  // Returns how far images are from iterates, |g(x) - x|, the largest of those computed; not finite
  // if a value is not or an unknown has none at some place, on any rank. Those of the fault come
  // first. Collective.
  double updateImages(FollowsFrom motion, StepIterate const& step, Norm norm);
  // Whether the images of those that follow from the body are due, too, when those of the fault
  // have changed by of_fault and the rate problem is solved or not.
  bool bodyIsDue(double of_fault, bool rate_converged, double tolerance) const;
  // The next iterates in `to` of those whose images are new. Where these change more than before
  // the last advance, the remembered iterates point away from the fixed point and are forgotten.
  // Returns whether forces change with them. Collective.
  bool advance(State const& to);
  // Ends the fixed point: the final values in `to`, see StepUnknown.
  void finish(State const& to) const;
  // Sets what follows from the unknowns at the end of that step, see StepUnknown.
  void complete(State const& from, double tau, State const& to) const;
  // All images in `to`.
  void copyImages(State const& to) const;

  // The error of a step that ends in a, if b is its exact end: the largest of the unknowns that are
  // iterated, each times its scale in the last step. Between steps. Collective.
  double distance(State const& a, State const& b, Norm norm) const;

private:
  class NodesOfFault final : public UnknownSpace
  {
  public:
    explicit NodesOfFault(fem::FaultSurface const& surface) : surface_(surface) {}
    ConstNodeView weights() const override { return surface_.weights(); }
    RCP<const Communicator> communicator() const override { return surface_.communicator(); }
    double distance(ConstNodeView const& values, ConstNodeView const& exact,
                    Norm norm) const override
    {
      return dynamics::distance(surface_, values, exact, norm);
    }

  private:
    fem::FaultSurface const& surface_;
  };

  struct Entry
  {
    std::shared_ptr<StepUnknown> unknown;
    NodeView image;
  };

  // Unknowns that are accelerated together.
  struct Group
  {
    Group(UnknownSpace const& space, FollowsFrom motion, int depth);
    void add(std::shared_ptr<StepUnknown> unknown);
    NodeView part(NodeView const& all, std::size_t entry) const;
    void begin();
    double updateImages(StepIterate const& step, Norm norm);
    bool advance(State const& to);
    double distance(State const& a, State const& b, Norm norm) const;

    UnknownSpace const& space;
    FollowsFrom motion;
    AndersonAcceleration acceleration;
    std::vector<Entry> entries;
    NodeView x, images;      // (num_unknowns num_values)
    bool is_updated = false; // in this iteration
    double change = 0;       // of the last images in this step; 0 before
    double ratio = 0;        // of this change to that before it; 0 until there are two
    double last_advanced = std::numeric_limits<double>::infinity(); // the change before that
  };

  StepUnknownList unknowns_;
  NodesOfFault nodes_;
  std::list<Group> groups_;
};
} // namespace asperity::dynamics
