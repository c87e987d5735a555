#pragma once

#include "dynamics/initial/Model.hpp"

#include <memory>
#include <vector>

namespace asperity::tnnmg
{
class CondensedRightSide;
class SchurComplement;
} // namespace asperity::tnnmg

namespace asperity::dynamics
{
// Static condensation (Guyan 1965) of a body that has neither inertia, viscosity nor loads off its
// fault. It is in equilibrium at all times, so that the fault and the boundaries determine its
// displacement:
//
//   u = E u_F + s P:    K_II u_I = -K_IF u_F - s K_ID d,    u_D = s d
//
// F are all dofs at the vertices of the fault, D the other held dofs, I the rest. D moves at the
// constant velocity d, so that its amplitude s [s] is a single held dof, which moves at rate 1. The
// condensed model has [E P]'K[E P], which is full, for K. Works, energies and reactions are the
// same in both models, and so is every step of a scheme that is linear in u, v and a. A step costs
// as much as in a boundary element code, for any number of cells.
class StaticCondensation
{
public:
  // The amplitudes of the motion of D in the fields of State::visitBody, in their order: s in u,
  // and its derivatives in the others.
  using Amplitudes = std::vector<double>; // (numAmplitudes())

  // `whole` must live on one rank, its load must act on F alone, and prescribed velocities must
  // be constant in time, except at the tangential dofs of the fault; it must outlive the result.
  // Null if the body has mass, viscosity off F, Maxwell branches, or a displacement at the start,
  // or is not in equilibrium for some motion of F.
  static std::unique_ptr<StaticCondensation> make(Model const& whole);
  ~StaticCondensation();

  // Vertex i of its dofs is node i of the fault, with all components; the last vertex has s.
  Model const& model() const { return *model_; }
  int numEliminated() const; // the size of I and D
  // The reaction across the fault of the condensed model, from that of the whole body.
  ReactionSinceStart reactionFrom(ReactionSinceStart const& of_whole) const
  {
    return condensedReaction(of_whole, model_->body);
  }
  // Displacement, velocity or acceleration of the whole body from that of the condensed model.
  void expand(Vector const& x, Vector& whole) const;

  // The row of expand() for a dof of the whole body: row . x is its value, with as many numbers as
  // the condensed model has dofs. Costs a solve with half of the factor.
  std::vector<double> recoveryRow(int dof) const;
  // How many numbers expand() reads, which is its cost.
  std::size_t factorEntries() const;

  // expand: the state of the whole body from one of the condensed model; gather: the reverse, which
  // also needs the amplitudes: those of a condensed state, or, for a state of a body that has never
  // been condensed, those at its time [s].
  State expand(State const& state) const;
  State gather(State const& whole, Amplitudes const& boundary_amplitudes) const;
  Amplitudes amplitudes(State const& state) const;
  Amplitudes amplitudesAt(double time) const;
  std::size_t numAmplitudes() const { return whole_.initial.numBodyFields(); }

private:
  explicit StaticCondensation(Model const& whole);

  bool isFaultAlone(CrsMatrix const& viscosity) const;
  bool findPattern();
  bool factorise();
  void noteMovingDofs(Vector const& prescribed_velocity);
  bool isInEquilibrium(Vector const& u) const;
  bool balancesMotionOfFault() const;
  void condense();
  Body condensedBody() const;
  RCP<const CrsMatrix> condensedStiffness(RCP<const Map> const& map) const;
  RCP<const CrsMatrix> condensedViscosity(RCP<const Map> const& map) const;
  fem::HeldDofs condensedHeld(int num_dofs) const;
  std::shared_ptr<const fem::FaultSurface> condensedSurface(fem::HeldDofs const& held) const;
  State condensedState(Body const& body) const;
  ReactionSinceStart condensedReaction(ReactionSinceStart const& of_whole, Body const& body) const;
  State gather(State const& whole, Body const& condensed,
               Amplitudes const& boundary_amplitudes) const;
  void gather(Vector const& whole, Vector& x) const; // F alone; s and all other dofs are zero

  int numKept() const { return static_cast<int>(kept_.size()); }

  Model const& whole_;
  std::vector<int> kept_;                                // F, in the order of the condensed dofs
  std::vector<int> place_;                               // of a dof of the whole body in F, or -1
  std::vector<bool> moves_;                              // whether a dof of F may have a velocity
  RCP<Vector> pattern_;                                  // P
  bool is_driven_ = false;                               // whether d is not zero
  std::unique_ptr<tnnmg::SchurComplement> factor_;       // of K without the rows and columns of D
  std::unique_ptr<tnnmg::CondensedRightSide> no_forces_; // whose expand() is E
  std::unique_ptr<Model> model_;
};
} // namespace asperity::dynamics
