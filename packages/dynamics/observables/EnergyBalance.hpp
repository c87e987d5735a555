#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/State.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/fault/OpeningForces.hpp"

#include <array>
#include <optional>
#include <vector>

namespace asperity::dynamics
{
// Energies and works: in J, in 2D per unit of thickness [J/m]. Works count from the start of the
// run.
struct Energy
{
  double kinetic = 0;
  double elastic = 0;   // 1/2 u'Ku + sum of 1/2 d_k'K_k d_k, of the strain that is not inelastic
  double load_work = 0; // by gravity and tractions, and by plates that move (back slip)
  double boundary_work = 0;  // by the forces that move the prescribed boundaries
  double friction_work = 0;  // dissipated on the fault
  double viscous_work = 0;   // dissipated in the body, by radiation damping and by dashpots
  double inelastic_work = 0; // dissipated by rock that yields
  double contact_work = 0;   // dissipated where the sides of a fault meet or part
  // By the time scheme; may be negative for a while. Includes the energy that a quasi-dynamic body
  // loses in the first step if it starts out of balance.
  double numerical_dissipation = 0;
  // Change of kinetic and elastic energy minus (load_work + boundary_work - friction_work -
  // viscous_work - inelastic_work - numerical_dissipation - contact_work): the error that the
  // tolerances of the solvers leave.
  double defect = 0;

  struct Member
  {
    char const* name;
    double Energy::*value;
  };
  static std::array<Member, 10> const& members();
};

// The balance of energy from step to step, with du = u1 - u0, dv = v1 - v0 and means over the ends
// of the step:
//   change of (1/2 v'Mv + 1/2 u'Ku) = du . (mean l - C mean v - mean f) - D
//   D = du . M mean a - mean v . M dv,    mean v . M dv = change of 1/2 v'Mv
// Of it a Maxwell branch dissipates mean K_k d_k . (du - change of d_k) as viscous work, and rock
// that yields the integral of its mean stress times the change of its inelastic strain. f are the
// friction forces of the last rate problem and the reactions of prescribed dofs. The balance is
// exact where that of momentum holds at both ends; D is what the scheme dissipates, none of Newmark
// with beta = 1/4 (README.md). Under back slip the fault slips by Vp tau more than the bodies move:
// what friction and radiation damping dissipate in this slip is work of the plates.
//
// On a fault that may open the forces of OpeningForces are loads, and -f at the dofs across is the
// stress of contact times its support. The mean of it over the ends of a step times the change of
// the opening is the work of contact: zero where the fault stays shut or open. With the trapezoidal
// rule that mean is the force of contact in the step (StepOpening), and its work never negative;
// otherwise it is where the fault closes, and of the opposite sign where it opens.
//
// A quasi-dynamic body cannot stay out of balance: if r0 = l - C v - K u - f is not zero at the
// start, then velocity and forces jump at once. The first step is driven by the forces after the
// jump, for which the mean over its ends takes f + r0 in place of f at its beginning:
//   on the fault      1/2 r0 . du of friction work, which includes the part of radiation damping
//   inside the body   1/2 r0 . du of numerical dissipation: the energy l . du - change of 1/2 u'Ku
//                     that the body loses when it moves to equilibrium; with inertia, as waves
class EnergyBalance
{
public:
  // since_start has a reaction if the fault may open.
  EnergyBalance(Body const& body, Fault const& fault, DyadicTime const& clock,
                ReactionSinceStart const& since_start = {});

  // Begins a run at a state.
  void start(State const& state);
  // Continues a run from the state at the end of a step, with the works done so far.
  void resume(State const& state, Energy const& so_far);
  // Of StartForces.hpp: dynamics::startImbalance of a quasi-dynamic body, startContradiction of one
  // with inertia; 0 for others, and after resume().
  double startImbalance() const { return start_imbalance_; }
  double startContradiction() const { return start_contradiction_; }
  // Adds the step that ends in the given state. Collective.
  Energy const& advance(State const& state);
  Energy const& energy() const { return energy_; }
  Fault const& fault() const { return fault_; }
  // Friction forces on the fault and reactions at held dofs, and forces of contact where a fault
  // may open, at the last state [N per unit of thickness].
  Vector const& force() const { return *before_.force; }
  // w(num_nodes, T) of gatherSlip at the last state.
  ConstBlockView slipVelocity() const { return w_; }

private:
  struct Snapshot
  {
    RCP<Vector> u, v, load, force;
    std::vector<RCP<Vector>> d; // of the Maxwell branches
    BodyForces resisting;
    double kinetic = 0, elastic = 0;
    double inelastic = 0; // fem::InelasticCells::energy
    DyadicTime::Ticks time = 0;
  };
  // Works of one step.
  struct Works
  {
    double load = 0, boundary = 0, friction = 0, viscous = 0, inelastic = 0, inertial = 0,
           contact = 0;
  };
  Snapshot snapshot() const;
  void fill(State const& state, Snapshot& result);
  void fillForce(State const& state, Snapshot const& at);
  Works worksOfStep() const;
  void jump();

  Body const& body_;
  Fault const& fault_;
  DyadicTime clock_;
  IndexView fault_dofs_;                 // that are not held
  IndexView dofs_across_;                // that are not held, where the fault may open
  std::optional<OpeningForces> opening_; // if the fault may open
  Snapshot before_, after_;
  RCP<Vector> momentum_;
  RCP<Vector> start_residual_; // r0, until the first step is made; null if there is none
  double start_imbalance_ = 0, start_contradiction_ = 0;
  ConstNodeView eta_;      // (num_nodes) radiation damping [Pa s/m], or nothing
  BlockView w_, gradient_; // w of gatherSlip, and the friction forces at it
  HessianView hessian_;
  FlagView kinked_;
  Energy energy_;
};
} // namespace asperity::dynamics
