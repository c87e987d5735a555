#include "verification/waves/Waves.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

namespace asperity::verification
{
namespace
{
// On right triangles of one orientation a plane wave along x is one in one dimension, except where
// the mesh ends: there it is prescribed, as this very wave, on all sides but that of the fault.
// Everything inside has to follow, step by step, to the last digits.
void expectTheDiscreteWave(Wave wave, dynamics::RateUpdate const& update, double viscosity)
{
  const double length = 1, q = 2.5 * M_PI / length, dt = 2e-3;
  const int cells = 24;
  auto options = freeSliding(wave, fem::test::uniformRectangle(cells, 6, length, 0.2));
  options.material.bulk_viscosity *= viscosity;
  options.material.shear_viscosity *= viscosity;
  auto const moduli = moduliOf(wave, options.material);
  const double c = std::sqrt(moduli.elastic / options.material.density);
  const Complex s = rootOf(moduli, discreteFrequency(c, q, length / cells));
  const Complex factor = factorOf(update, s, dt);
  for (char const* side : {"bottom", "top", "right"}) {
    for (int component = 0; component < options.components; ++component) {
      std::vector<double> direction(options.components, 0.);
      direction[component] = 1;
      auto const velocity = [=](Point<2> const& x, double t) {
        const Complex now = std::pow(factor, std::lround(t / dt));
        return now.real() * shapeOf(wave, q, x)[component];
      };
      options.conditions.push_back({side, side, fem::PrescribedVelocity<2>{direction, velocity}});
    }
  }
  const Model model(options, fem::test::selfCommunicator());
  Stepper stepper(model, update, dynamics::DyadicTime(dt, 0));
  Complex U = 1. / s;
  auto state = waveState(model, wave, q, s, U);
  const double amplitudes[] = {std::abs(U), 1, std::abs(s)};
  for (int n = 0; n < 60; ++n) {
    advance(stepper, state, 0);
    U *= factor;
    auto const expected = waveState(model, wave, q, s, U);
    ASSERT_LE(largestDifference(*state.u, *expected.u), 1e-11 * amplitudes[0]) << "step " << n;
    ASSERT_LE(largestDifference(*state.v, *expected.v), 1e-11 * amplitudes[1]) << "step " << n;
    ASSERT_LE(largestDifference(*state.a, *expected.a), 1e-10 * amplitudes[2]) << "step " << n;
  }
}

constexpr Wave waves[] = {Wave::antiplane_shear, Wave::shear, Wave::compression};
} // namespace

TEST(Dispersion, OfDampedWavesWithTheTrapezoidalRule)
{
  for (Wave wave : waves) {
    expectTheDiscreteWave(wave, dynamics::RateUpdate::newmark(0.25), 1);
  }
}

TEST(Dispersion, OfUndampedWavesWithTheTrapezoidalRule)
{
  for (Wave wave : waves) {
    expectTheDiscreteWave(wave, dynamics::RateUpdate::newmark(0.25), 0);
  }
}

TEST(Dispersion, OfOverdampedWaves)
{
  for (Wave wave : waves) {
    expectTheDiscreteWave(wave, dynamics::RateUpdate::newmark(0.25), 40);
  }
}

TEST(Dispersion, OfDampedWavesWithBackwardEuler)
{
  for (Wave wave : waves) {
    expectTheDiscreteWave(wave, dynamics::RateUpdate::backwardEuler(), 1);
  }
}
} // namespace asperity::verification
