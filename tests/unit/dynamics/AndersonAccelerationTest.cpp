#include "dynamics/coupling/AndersonAcceleration.hpp"

#include "dynamics/fault/FaultMotion.hpp"
#include "unit/dynamics/FaultNodesOfTests.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::dynamics
{
namespace
{

constexpr int num_nodes = 12; // on all ranks together

// g(x) = s + c (x - s) with the fixed point s and factors of contraction c, node by node, which the
// ranks share out.
class Contraction
{
public:
  explicit Contraction(std::vector<double> const& factors)
      : factors_(mine([&](int node) { return factors[node % factors.size()]; }))
      , weights_(mine([](int node) { return 1 + 0.1 * node; }))
      , solution_(mine([](int node) { return std::sin(1. + node); }))
      , fault(dynamics::test::surfaceOf(weights_, 1, std::vector<int>(num_nodes, 0),
                                        fem::OtherSide::rigid_foundation, Tpetra::getDefaultComm()))
      , solution(view(solution_))
  {
  }

  NodeView image(NodeView const& x) const
  {
    const NodeView result("image", x.extent(0));
    for (std::size_t i = 0; i < x.extent(0); ++i) {
      result(i) = solution_[i] + factors_[i] * (x(i) - solution_[i]);
    }
    return result;
  }

  AndersonAcceleration acceleration(int depth) const
  {
    return {fault.weights(), fault.communicator(), depth};
  }

  NodeView zero() const { return NodeView("x", factors_.size()); }

  // From the fixed point after so many maps, beginning with 0.
  double errorAfter(int num_maps, AndersonAcceleration& acceleration) const
  {
    auto const x = zero();
    for (int i = 0; i < num_maps; ++i) {
      acceleration.advance(x, image(x));
    }
    return distance(fault, x, solution);
  }

private:
  // Of this rank's nodes.
  template <class Value>
  static std::vector<double> mine(Value const& value)
  {
    auto const comm = Tpetra::getDefaultComm();
    std::vector<double> values;
    for (int node = comm->getRank(); node < num_nodes; node += comm->getSize()) {
      values.push_back(value(node));
    }
    return values;
  }

  static NodeView view(std::vector<double> const& values)
  {
    const NodeView result("values", values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      result(i) = values[i];
    }
    return result;
  }

  std::vector<double> factors_, weights_, solution_;

public:
  fem::FaultSurface fault;
  NodeView solution;
};
} // namespace

// Two factors: the plane of three iterates holds the fixed point, the fourth map finds it.
TEST(AndersonAcceleration, SolvesAsManyDirectionsAsItRemembers)
{
  const Contraction contraction({0.9, 0.5});
  auto remembers = contraction.acceleration(2), forgets = contraction.acceleration(1);
  EXPECT_LE(contraction.errorAfter(3, remembers), 1e-11); // what normal equations leave
  EXPECT_GE(contraction.errorAfter(3, forgets), 1e-3);
}

TEST(AndersonAcceleration, OfDepthZeroIsTheFixedPointIteration)
{
  const Contraction contraction({0.5});
  auto plain = contraction.acceleration(0);
  const double start = distance(contraction.fault, contraction.zero(), contraction.solution);
  EXPECT_NEAR(contraction.errorAfter(4, plain), start / 16, 1e-15);
}

// Of one remembered iterate: gamma = <f1, f1 - f0> / |f1 - f0|^2 in the mean square over the fault.
TEST(AndersonAcceleration, FindsTheSmallestResidualOverTheFault)
{
  const Contraction contraction({0.8, 0.3, -0.4});
  auto acceleration = contraction.acceleration(1);
  auto const x0 = contraction.zero(), x = contraction.zero();
  auto const g0 = contraction.image(x0);
  acceleration.advance(x, g0);
  auto const g1 = contraction.image(x);
  double sums[2] = {0, 0}, all[2];
  for (std::size_t i = 0; i < x.extent(0); ++i) {
    const double f0 = g0(i), f1 = g1(i) - g0(i),
                 weight = contraction.fault[static_cast<int>(i)].weight;
    sums[0] += weight * f1 * (f1 - f0);
    sums[1] += weight * (f1 - f0) * (f1 - f0);
  }
  Teuchos::reduceAll(*contraction.fault.communicator(), Teuchos::REDUCE_SUM, 2, sums, all);
  acceleration.advance(x, g1);
  for (std::size_t i = 0; i < x.extent(0); ++i) {
    EXPECT_NEAR(x(i), g1(i) - all[0] / all[1] * (g1(i) - g0(i)), 1e-13);
  }
}

TEST(AndersonAcceleration, StartsAnewAfterAReset)
{
  const Contraction contraction({0.9, 0.5, 0.2});
  auto used = contraction.acceleration(2), fresh = contraction.acceleration(2);
  contraction.errorAfter(5, used);
  used.reset();
  EXPECT_EQ(contraction.errorAfter(3, used), contraction.errorAfter(3, fresh));
}

TEST(AndersonAcceleration, StaysWhereItHasArrived)
{
  const Contraction contraction({0});
  auto acceleration = contraction.acceleration(2);
  EXPECT_EQ(contraction.errorAfter(6, acceleration), 0);
}
} // namespace asperity::dynamics
