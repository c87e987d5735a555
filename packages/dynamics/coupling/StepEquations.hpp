#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/RateUpdate.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/StepOpening.hpp"
#include "dynamics/coupling/StepUnknowns.hpp"

#include <optional>
#include <vector>

namespace asperity::dynamics
{
// The linear part of a step: what follows from the state at its beginning, from loads and from
// prescribed velocities, and the fields at its end that follow from the solution.
//
// The rate problem is solved for w = v1 - v_D, which is zero at held dofs. v_D is the prescribed
// velocity; under back slip it is the motion of the plates at the free dofs of the fault, so that
// friction depends on w there (gatherSlip). Where a held dof of the fault slips beside a free one,
// friction depends on the prescribed rate of it, too.
class StepEquations
{
public:
  // All but since_start must outlive this; that has a reaction if the fault may open.
  StepEquations(Body const& body, Fault const& fault, RateUpdate const& update,
                StepUnknowns const& unknowns, ReactionSinceStart const& since_start);
  StepEquations(StepEquations const&) = delete; // it refers to another member of a step
  StepEquations& operator=(StepEquations const&) = delete;

  // Sets what the unknowns do not change, for a step of tau [s] from `from`, which goes from t0 to
  // t1 [s]: v_D, the loads, the forces of the past and of v_D, and the offset of the mean velocity.
  // Evaluates the deck's expressions, those of the unknowns, too. If one fails on a rank, all ranks
  // throw. Collective.
  void begin(State const& from, double tau, double t0, double t1);
  // b(owned dofs) of the rate problem with the iterates of the unknowns in `to`:
  //   b = l(t1) - M a_D - C v_D - K u_D - sum of K_k d_D + forces of unknowns on the free dofs,
  // where u_D, a_D and d_D follow from v_D by the rate update. Where the fault may open, the
  // forces of StepOpening are added.
  Vector const& setRightSide(State const& to);
  // As setRightSide has left it.
  RCP<Vector> const& rightSide() const { return b_; }

  // w := v - v_D at free dofs and 0 at held dofs (owned dofs).
  void removePrescribed(Vector const& v, Vector& w) const;
  // v := w + v_D (owned dofs); v may be w.
  void addPrescribed(Vector const& w, Vector& v) const;
  // The same problem where friction also depends on prescribed rates beside free ones.
  FrictionProblem withPrescribed(FrictionProblem const& friction) const;
  // Null unless the fault may open.
  StepOpening const* opening() const { return opening_ ? &*opening_ : nullptr; }
  // From the w of gatherSlip at the end of the step to its mean over the step, in place: blocks
  // (num_nodes, T) [m/s].
  void takeMean(BlockView const& blocks) const;
  // u(owned dofs) at the end of the step for w of the whole body; until the next call here.
  Vector const& displacementAtEnd(Vector const& w, double tau);
  // Computes u, a, jerk and branches of `to`, which has v.
  void complete(State const& from, double tau, State& to) const;

private:
  Body const& body_;
  fem::FaultSurface const& surface_;
  RateUpdate const& update_;
  StepUnknowns const& unknowns_;
  RCP<Vector> v_D_, u_hat_, a_hat_, b_;
  RCP<Vector> b_without_unknowns_; // null if none adds forces and the fault cannot open
  BodyForces forces_;
  BlockView mean_offset_;              // the part of takeMean that w does not change
  BlockView prescribed_part_;          // gatherPrescribedPart at the end of the step
  bool has_prescribed_part_ = false;   // whether it has any
  std::optional<StepOpening> opening_; // if the fault may open
  // Memory that a function fills before it reads it: vectors of a large body are made once.
  RCP<Vector> u_, v_, a_;
  std::vector<RCP<Vector>> d_;
};
} // namespace asperity::dynamics
