#pragma once

#include "ElasticModel.hpp"
#include "RoughNodes.hpp"
#include "tnnmg/Tnnmg.hpp"

#include <iosfwd>
#include <map>

namespace asperity::tnnmg::test
{
enum class Kind
{
  threshold, // some nodes stay at rest, the others slide against a constant force
  logarithm, // all nodes move, some at rates that only the logarithm knows
  both
};

struct RateProblemOptions
{
  double tau = 1e-3; // s
  int components = 2;
  int tangents = 1;
  Kind kind = Kind::both;
  std::vector<int> walls = {}; // as in ElasticModelOptions
};
void PrintTo(RateProblemOptions const& options, std::ostream* out);

// The body of ElasticModel, pushed, on a fault of Roughness that about half of its nodes can
// resist.
struct RateProblem
{
  explicit RateProblem(RateProblemOptions const& options);

  RoughNodes nodesOfRank() const;
  // Of this rank's nonlinear nodes, by component: 1 where the velocity is held, at walls or given.
  std::vector<std::vector<int>> heldOnRank(std::map<int, double> const& held) const;

  // J(v) and the sum of the magnitudes of its terms, in long double.
  struct Energy
  {
    long double value = 0;
    long double magnitude = 0;
  };
  Energy energy(Eigen::VectorXd const& v) const;
  double energyNorm(Eigen::VectorXd const& v) const;

  // The minimiser, by coordinate descent on the dense Schur complement in long double. The first
  // component of the nodes in `held` has the given value and others none; walls bear any force.
  Eigen::VectorXd reference(std::map<int, double> const& held = {}) const;

  ElasticModel model;
  Eigen::VectorXd b;
  std::vector<Roughness> nodes; // all, on every rank
};
} // namespace asperity::tnnmg::test
