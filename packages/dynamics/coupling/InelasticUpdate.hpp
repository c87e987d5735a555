#pragma once

#include "dynamics/State.hpp"
#include "dynamics/coupling/AndersonAcceleration.hpp"
#include "dynamics/fault/Norm.hpp"

namespace asperity::dynamics
{
// The inelastic strain of the body's cells within a step: an unknown of its fixed point that the
// rate problem takes as given. Elastic rock with a given inelastic strain has a potential that
// touches the one of rock that yields where this strain follows from the displacement, and exceeds
// it elsewhere (fem/bulk/ReturnMapping.hpp). So J falls from one rate problem to the next as long
// as alpha, normal stress and mean stress stay, and Z is that of elastic rock.
class InelasticUpdate
{
public:
  // depth: of the acceleration. cells must outlive this.
  InelasticUpdate(fem::InelasticCells const& cells, int depth);

  // Begins a step with the right side b that it has without inelastic strain.
  void begin(Vector const& b);
  // b := that right side and the forces of the strain in `to`.
  void rightSide(State const& to, Vector& b) const;

  // Computes the image: the strain after the step [s] from `from` if it ends with the displacement
  // u. Collective.
  void respond(Vector const& u, double tau, State const& from);
  // How far the image is from the iterate in `to`, see fem::InelasticCells::distance. Where this is
  // more than before, the remembered iterates point away from the fixed point and are forgotten.
  // Collective.
  double change(State const& to, Norm norm);
  // The same from the strain in one state to that in another.
  double distance(State const& a, State const& b, Norm norm) const;
  // The last change in this step; 0 before.
  double lastChange() const { return last_change_; }
  // The change to expect next: as much smaller as the last one was than that before it. 0 until
  // there are two.
  double expectedChange() const { return last_change_ * ratio_; }
  // The next iterate in `to`. Collective.
  void advance(State& to);
  // The image in `to`, with which the step ends.
  void copyImage(State& to) const;

private:
  fem::InelasticCells const& cells_;
  AndersonAcceleration acceleration_;
  RCP<Vector> b_; // without inelastic strain
  fem::InelasticStrain image_;
  double last_change_ = 0, ratio_ = 0;
};
} // namespace asperity::dynamics
