#include "dynamics/RateUpdate.hpp"

#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

namespace asperity::dynamics
{
namespace
{
// One number for each of u, v, a at one time.
struct Motion
{
  double u, v, a;
};

class OneDof
{
public:
  // u1 and a1 after a step to the velocity v1.
  Motion step(RateUpdate const& update, Motion const& from, double tau, double v1)
  {
    Vector u(map_), v(map_), a(map_), u_hat(map_), a_hat(map_);
    u.putScalar(from.u);
    v.putScalar(from.v);
    a.putScalar(from.a);
    u_hat.putScalar(123);
    a_hat.putScalar(123);
    update.predict(u, v, a, tau, u_hat, a_hat);
    v.putScalar(v1);
    update.complete(v, tau, u_hat, a_hat);
    return {u_hat.getData()[0], v1, a_hat.getData()[0]};
  }

private:
  RCP<const Map> map_ = rcp(new Map(1, 0, fem::testing::selfCommunicator()));
};

const Motion start = {0.3, -1.7, 2.9};
} // namespace

// Pipping 2014, table 3.1: the equations that define the schemes, for any v1.
TEST(RateUpdate, newmarkSatisfiesItsEquations)
{
  OneDof dof;
  for (double beta : {0., 0.25, 0.3, 0.5}) {
    for (double tau : {1e-3, 0.7}) {
      auto const end = dof.step(RateUpdate::newmark(beta), start, tau, 4.2);
      EXPECT_NEAR(end.v, start.v + tau * (start.a + end.a) / 2, 1e-13);
      EXPECT_NEAR(end.u,
                  start.u + tau * start.v +
                    tau * tau / 2 * ((1 - 2 * beta) * start.a + 2 * beta * end.a),
                  1e-13);
    }
  }
}

TEST(RateUpdate, backwardEulerSatisfiesItsEquations)
{
  OneDof dof;
  for (double tau : {1e-3, 0.7}) {
    auto const end = dof.step(RateUpdate::backwardEuler(), start, tau, 4.2);
    EXPECT_NEAR(end.v, start.v + tau * end.a, 1e-13);
    EXPECT_NEAR(end.u, start.u + tau * end.v, 1e-13);
  }
}

TEST(RateUpdate, newmarkFollowsConstantAccelerationExactly)
{
  OneDof dof;
  Motion motion = {0, 1, -3};
  double t = 0;
  for (double tau : {0.1, 0.025, 0.2, 0.1}) {
    t += tau;
    motion = dof.step(RateUpdate::newmark(0.25), motion, tau, 1 - 3 * t);
    EXPECT_NEAR(motion.u, t - 1.5 * t * t, 1e-14);
    EXPECT_NEAR(motion.a, -3, 1e-12);
  }
}

// The weights of Z = (lambda_M / tau) M + C + (tau / lambda_K) K are the derivatives by v1.
TEST(RateUpdate, weightsAreTheDerivativesByTheNewVelocity)
{
  OneDof dof;
  const double tau = 0.4;
  for (auto const& update :
       {RateUpdate::newmark(0.25), RateUpdate::newmark(0.4), RateUpdate::backwardEuler()}) {
    auto const low = dof.step(update, start, tau, 1);
    auto const high = dof.step(update, start, tau, 3);
    EXPECT_NEAR((high.a - low.a) / 2, update.mass_weight / tau, 1e-13) << update.name;
    EXPECT_NEAR((high.u - low.u) / 2, update.stiffness_weight * tau, 1e-13) << update.name;
  }
}
} // namespace asperity::dynamics
