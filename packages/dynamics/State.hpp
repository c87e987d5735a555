#pragma once

#include "base/Types.hpp"
#include "dynamics/control/DyadicTime.hpp"
#include "friction/Types.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
// Everything that the future of a run depends on, at one time. The vectors have the owned dofs, in
// nodal frames.
struct State
{
  DyadicTime::Ticks time = 0;
  RCP<Vector> u, v, a;        // m, m/s, m/s^2
  RCP<Vector> jerk;           // m/s^3, of the last step, see RateUpdate; zero at the start
  friction::NodeView alpha;   // (num fault nodes)
  friction::NodeView sigma_n; // (num fault nodes) [Pa], positive in compression
  // The alpha of the last rate problem, with which v was computed.
  friction::NodeView alpha_of_rate;

  // A state of the same shapes, whose values are not set.
  State sameShape() const
  {
    constexpr bool set_to_zero = false;
    State other;
    other.u = rcp(new Vector(u->getMap(), set_to_zero));
    other.v = rcp(new Vector(v->getMap(), set_to_zero));
    other.a = rcp(new Vector(a->getMap(), set_to_zero));
    other.jerk = rcp(new Vector(jerk->getMap(), set_to_zero));
    other.alpha = friction::NodeView("asperity::dynamics::alpha", alpha.extent(0));
    other.sigma_n = friction::NodeView("asperity::dynamics::sigma_n", sigma_n.extent(0));
    other.alpha_of_rate = friction::NodeView("asperity::dynamics::alphaOfRate", alpha.extent(0));
    return other;
  }

  State clone() const
  {
    State copy = sameShape();
    copy.time = time;
    Tpetra::deep_copy(*copy.u, *u);
    Tpetra::deep_copy(*copy.v, *v);
    Tpetra::deep_copy(*copy.a, *a);
    Tpetra::deep_copy(*copy.jerk, *jerk);
    Kokkos::deep_copy(copy.alpha, alpha);
    Kokkos::deep_copy(copy.sigma_n, sigma_n);
    Kokkos::deep_copy(copy.alpha_of_rate, alpha_of_rate);
    return copy;
  }
};
} // namespace asperity::dynamics
