#pragma once

#include "unit/dynamics/SmallModel.hpp"

namespace asperity::dynamics::testing
{
// A state in plain vectors; alpha at the fault nodes.
struct DenseState
{
  Eigen::VectorXd u, v, a, alpha;
};

DenseState denseOf(State const& state);

// Steps of the same equations by Newton's method on dense matrices, for the regularised law and the
// ageing law where every free fault node slides. Written from the equations, not from the solver;
// of the model it takes matrices, weights, loads and prescribed velocities. One rank.
class DenseReference
{
public:
  enum class Scheme
  {
    newmark,
    backward_euler
  };

  DenseReference(Model const& model, Scheme scheme, double beta, double lambda);

  // The state after a step of tau [s] that ends at the time t1.
  DenseState step(DenseState const& from, double t1, double tau) const;

private:
  struct NodalFriction
  {
    double force, alpha;
  };
  NodalFriction friction(int i, double v0, double v1, double alpha0, double tau) const;
  void complete(DenseState const& from, double tau, DenseState& to) const;
  Eigen::VectorXd imbalance(DenseState const& from, double tau, Eigen::VectorXd const& load,
                            DenseState& to) const;

  Model const& model_;
  Scheme scheme_;
  double beta_, lambda_;
  Eigen::MatrixXd mass_, viscosity_, stiffness_;
  std::vector<int> free_;
};
} // namespace asperity::dynamics::testing
