#pragma once

#include "unit/dynamics/SmallModel.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <cmath>
#include <complex>

// Plane waves along x in a Kelvin-Voigt body whose left side is a fault without friction, and what
// is known of them, M the modulus and eta the viscosity of the wave:
//   continuous                   rho s^2 + eta q^2 s + M q^2 = 0
//   P1, consistent mass, in 1D   c^2 q^2 becomes w^2, w^2 h^2 / c^2 = 6 (1 - cos qh) / (2 + cos qh)
//   Newmark, beta = 1/4          exp(s dt) becomes (1 + s dt/2) / (1 - s dt/2)
//   backward Euler               exp(s dt) becomes 1 / (1 - s dt)
namespace asperity::verification
{
using namespace dynamics::test;
using Complex = std::complex<double>;

enum class Wave
{
  antiplane_shear,
  shear, // displacement along y
  compression
};

// Rock-like Poisson's ratio, another ratio of bulk to shear in viscosity.
constexpr fem::Material material = {1000, 1.8e6, 1e6, 7e3, 2e3};

struct Moduli
{
  double elastic, viscous;
};

inline Moduli moduliOf(Wave wave, fem::Material const& m)
{
  if (wave == Wave::compression) {
    return {m.bulk_modulus + 4. / 3 * m.shear_modulus,
            m.bulk_viscosity + 4. / 3 * m.shear_viscosity};
  }
  return {m.shear_modulus, m.shear_viscosity};
}

// The root of s^2 + (eta / M) w^2 s + w^2 = 0 with positive imaginary part.
inline Complex rootOf(Moduli const& moduli, double w)
{
  const double damping = moduli.viscous / moduli.elastic * w * w / 2;
  return -damping + std::sqrt(Complex(damping * damping - w * w));
}

// w of sin(q x) for P1 elements of size h.
inline double discreteFrequency(double c, double q, double h)
{
  return c / h * std::sqrt(6 * (1 - std::cos(q * h)) / (2 + std::cos(q * h)));
}

inline Complex factorOf(dynamics::RateUpdate const& update, Complex s, double dt)
{
  return update.name == "Newmark" ? (1. + s * dt / 2.) / (1. - s * dt / 2.) : 1. / (1. - s * dt);
}

// The shape of a wave: what stands still or slides freely at x = 0.
inline std::array<double, 2> shapeOf(Wave wave, double q, Point<2> const& x)
{
  switch (wave) {
  case Wave::antiplane_shear: return {std::cos(q * x[0]), 0};
  case Wave::shear: return {0, std::cos(q * x[0])};
  default: return {std::sin(q * x[0]), 0};
  }
}

inline ModelOptions freeSliding(Wave wave, GlobalMesh<2> const& mesh)
{
  ModelOptions options;
  options.components = wave == Wave::antiplane_shear ? 1 : 2;
  options.mesh = mesh;
  options.fault = "left";
  options.material = material;
  options.sigma_n = 0;
  options.L = 1;
  return options;
}

// Re(U), Re(s U), Re(s^2 U) times a shape, on the free dofs and on the fixed ones alike.
inline dynamics::State waveState(Model const& model, Wave wave, double q, Complex s, Complex U)
{
  auto state = model.restingState();
  auto const fill = [&](Vector& x, double amplitude) {
    auto const values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int node = 0; node < model.mesh.num_owned; ++node) {
      auto const shape = shapeOf(wave, q, model.mesh.vertices[node]);
      for (int c = 0; c < model.options.components; ++c) {
        values(model.body.dofs->dof(node, c), 0) = amplitude * shape[c];
      }
    }
  };
  fill(*state.u, U.real());
  fill(*state.v, (s * U).real());
  fill(*state.a, (s * s * U).real());
  return state;
}

inline void advance(Stepper& stepper, dynamics::State& state, int level)
{
  auto next = state.clone();
  ASSERT_TRUE(stepper.step.solve(state, level, next, stepper.count).solved());
  state = next;
}

inline double largest(Vector const& x) { return denseOf(x).lpNorm<Eigen::Infinity>(); }

inline double largestDifference(Vector const& x, Vector const& y)
{
  return (denseOf(x) - denseOf(y)).lpNorm<Eigen::Infinity>();
}
} // namespace asperity::verification
