#pragma once

#include "dynamics/coupling/StepUnknown.hpp"

namespace asperity::dynamics
{
// A tensor in each of a body's cells that may yield, in one list.
class YieldingCells final : public UnknownSpace
{
public:
  explicit YieldingCells(fem::InelasticCells const& cells) : cells_(cells) {} // which outlive this

  ConstNodeView weights() const override;
  RCP<const Communicator> communicator() const override;
  // fem::InelasticCells::distance.
  double distance(ConstNodeView const& values, ConstNodeView const& exact,
                  Norm norm) const override;

private:
  fem::InelasticCells const& cells_;
};

// The inelastic strain of the body's cells within a step. Elastic rock with a given inelastic
// strain has a potential that touches the one of rock that yields where this strain follows from
// the displacement, and exceeds it elsewhere (fem/bulk/ReturnMapping.hpp). So J falls from one rate
// problem to the next as long as alpha, normal stress and mean stress stay, and Z is that of
// elastic rock.
class InelasticUpdate final : public StepUnknown
{
public:
  explicit InelasticUpdate(fem::InelasticCells const& cells); // which must outlive this

  NodeView valuesIn(State const& state) const override
  {
    return overwritten(state.inelastic->strain);
  }
  FollowsFrom followsFrom() const override { return FollowsFrom::body; }
  UnknownSpace const* space() const override { return &space_; }
  bool addsForces() const override { return true; }
  void addForces(State const& to, Vector& b) const override;
  int respond(StepIterate const& step, NodeView const& image) override;
  bool endsWithImage() const override { return true; }
  void finish(ConstNodeView const& image, State const& to) const override;

private:
  fem::InelasticCells const& cells_;
  YieldingCells space_;
  fem::InelasticStrain image_; // accumulated shear and history
};
} // namespace asperity::dynamics
