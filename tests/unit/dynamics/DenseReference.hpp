#pragma once

#include "unit/dynamics/SmallModel.hpp"

namespace asperity::dynamics::test
{
// A state in plain vectors; alpha at the fault nodes.
struct DenseState
{
  Eigen::VectorXd u, v, a, jerk, alpha;
};

DenseState denseOf(State const& state);

// Steps of the same equations by Newton's method on dense matrices, for the regularised law and the
// ageing law where every free fault node slides. Written from the equations, not from the solver;
// of the model it takes matrices, weights, stresses, loads and prescribed velocities. One rank.
class DenseReference
{
public:
  enum class Scheme
  {
    newmark,
    backward_euler,
    generalised_alpha
  };

  // `parameter`: beta of Newmark, the spectral radius of generalised alpha.
  DenseReference(Model const& model, Scheme scheme, double parameter);

  // The state after a step of tau [s] that ends at the time t1.
  DenseState step(DenseState const& from, double t1, double tau) const;

private:
  struct Step
  {
    DenseState const& from;
    double t1, tau;
    Eigen::VectorXd load;
  };
  // Of one dof: the displacement of a step, and what it ends with.
  struct Motion
  {
    double du, a, jerk;
  };
  struct NodalFriction
  {
    double force, alpha;
  };
  Motion motion(double v0, double a0, double jerk0, double v1, double tau) const;
  Motion motion(Step const& step, int dof, double v1) const;
  NodalFriction friction(Step const& step, int i, double v1) const;
  Eigen::VectorXd imbalance(Step const& step, DenseState& to) const;
  Eigen::MatrixXd jacobian(Step const& step, DenseState const& to) const;

  Model const& model_;
  Scheme scheme_;
  double parameter_;
  Eigen::MatrixXd mass_, viscosity_, stiffness_;
  std::vector<int> free_;
};
} // namespace asperity::dynamics::test
