#pragma once

#include "dynamics/RateUpdate.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::dynamics::test
{
// One number for each of u, v, a and the jerk of the last step.
struct DofMotion
{
  double u, v, a, jerk;
};

// m u'' + c u' + k u = 0
struct Oscillator
{
  double m, c, k;
};

// A rate update of a single dof.
class OneDof
{
public:
  // After a step to the velocity v1.
  DofMotion step(RateUpdate const& update, DofMotion const& from, double tau, double v1)
  {
    predict(update, from, tau);
    return complete(update, tau, v1);
  }

  // After a step in balance: (lambda_M/tau m + c + tau/lambda_K k) v1 = m a^ - k u^.
  DofMotion step(RateUpdate const& update, DofMotion const& from, double tau, Oscillator const& o)
  {
    predict(update, from, tau);
    const double Z = update.mass_weight / tau * o.m + o.c + tau * update.stiffness_weight * o.k;
    return complete(update, tau, (o.m * value(a_hat_) - o.k * value(u_hat_)) / Z);
  }

private:
  static double value(Vector const& x) { return x.getData()[0]; }

  State state() const
  {
    State result;
    for (auto* x : {&result.u, &result.v, &result.a, &result.jerk}) {
      *x = rcp(new Vector(map_));
      (*x)->putScalar(123); // whatever a step finds there
    }
    return result;
  }

  void predict(RateUpdate const& update, DofMotion const& from, double tau)
  {
    from_.u->putScalar(from.u);
    from_.v->putScalar(from.v);
    from_.a->putScalar(from.a);
    from_.jerk->putScalar(from.jerk);
    u_hat_.putScalar(123);
    a_hat_.putScalar(123);
    update.predict(from_, tau, u_hat_, a_hat_);
  }

  DofMotion complete(RateUpdate const& update, double tau, double v1)
  {
    auto to = state();
    to.v->putScalar(v1);
    update.complete(from_, u_hat_, a_hat_, tau, to);
    return {value(*to.u), value(*to.v), value(*to.a), value(*to.jerk)};
  }

  RCP<const Map> map_ = rcp(new Map(1, 0, fem::test::selfCommunicator()));
  State from_ = state();
  Vector u_hat_{map_}, a_hat_{map_};
};
} // namespace asperity::dynamics::test
