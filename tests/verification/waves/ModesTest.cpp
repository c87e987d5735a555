#include "verification/waves/Waves.hpp"

#include <Eigen/Eigenvalues>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

namespace asperity::verification
{
namespace
{
// A body between sliding walls and free sides, its cells all different; a standing wave of its own
// that nothing drives. Viscosities in the ratio of the moduli keep it one.
class ModesTest : public ::testing::TestWithParam<int>
{
protected:
  explicit ModesTest(double viscosity = 0)
  {
    auto mesh = fem::test::uniformRectangle(6, 5, 1, 0.7);
    fem::test::distort(mesh, 0.03);
    auto options = freeSliding(GetParam() == 1 ? Wave::antiplane_shear : Wave::shear, mesh);
    options.material.shear_viscosity = viscosity;
    options.material.bulk_viscosity =
      viscosity * options.material.bulk_modulus / options.material.shear_modulus;
    if (GetParam() == 2) {
      options.conditions = {{"Wall", "bottom", fem::SlidingWall{}}};
    }
    model = std::make_unique<Model>(options, fem::test::selfCommunicator());
    M = denseOf(*model->body.matrices.mass);
    K = denseOf(*model->body.matrices.stiffness);
  }

  // The mode of this number, M-normal; its frequency.
  Eigen::VectorXd mode(int which, double& w) const
  {
    std::vector<int> free;
    for (int dof = 0; dof < model->body.numOwnedDofs(); ++dof) {
      if (!model->body.held[dof]) {
        free.push_back(dof);
      }
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(K(free, free),
                                                                           M(free, free));
    w = std::sqrt(solver.eigenvalues()[which]);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(model->body.numOwnedDofs());
    result(free) = solver.eigenvectors().col(which);
    return result;
  }

  // Steps the mode and expects u = mode Re(factor^n / s).
  void expectFactor(dynamics::RateUpdate const& update, int which, double w_dt, int steps) const
  {
    double w = 0;
    auto const shape = mode(which, w);
    auto const& m = model->options.material;
    const Complex s = rootOf({m.shear_modulus, m.shear_viscosity}, w);
    const double dt = w_dt / w;
    Stepper stepper(*model, update, dynamics::DyadicTime(dt, 0));
    auto state = model->restingState();
    Complex U = 1. / s;
    assign(*state.u, U.real() * shape);
    assign(*state.v, (s * U).real() * shape);
    assign(*state.a, (s * s * U).real() * shape);
    const Complex factor = factorOf(update, s, dt);
    for (int n = 0; n < steps; ++n) {
      advance(stepper, state, 0);
      U *= factor;
      const Eigen::VectorXd rest = denseOf(*state.u) - U.real() * shape;
      ASSERT_LE(std::sqrt(rest.dot(M * rest)), 1e-9 / w) << "step " << n << ", w dt = " << w_dt;
    }
  }

  double energy(dynamics::State const& state) const
  {
    auto const u = denseOf(*state.u);
    auto const v = denseOf(*state.v);
    return (u.dot(K * u) + v.dot(M * v)) / 2;
  }

  static void assign(Vector& x, Eigen::VectorXd const& values)
  {
    auto const view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    std::copy(values.data(), values.data() + values.size(), &view(0, 0));
  }

  std::unique_ptr<Model> model;
  Eigen::MatrixXd M, K;
};

class UndampedModes : public ModesTest
{
};

class DampedModes : public ModesTest
{
protected:
  DampedModes() : ModesTest(1e3) {}
};
} // namespace

INSTANTIATE_TEST_SUITE_P(Components, UndampedModes, ::testing::Values(1, 2));
INSTANTIATE_TEST_SUITE_P(Components, DampedModes, ::testing::Values(1, 2));

// cos(n 2 atan(w dt / 2)), however large the step.
TEST_P(UndampedModes, SwingAtTheFrequencyOfTheTrapezoidalRule)
{
  for (double w_dt : {0.02, 1., 10.}) {
    for (int which : {2, 7}) {
      double w = 0;
      mode(which, w);
      const Complex factor = factorOf(dynamics::RateUpdate::newmark(0.25), Complex(0, w), w_dt / w);
      EXPECT_NEAR(std::arg(factor), 2 * std::atan(w_dt / 2), 1e-14);
      EXPECT_NEAR(std::abs(factor), 1, 1e-14);
      expectFactor(dynamics::RateUpdate::newmark(0.25), which, w_dt, 100);
    }
  }
}

TEST_P(UndampedModes, KeepTheEnergyOfAnyMotionWithTheTrapezoidalRule)
{
  Stepper stepper(*model, dynamics::RateUpdate::newmark(0.25), dynamics::DyadicTime(5e-3, 4));
  auto state = model->restingState();
  double w = 0;
  Eigen::VectorXd v = mode(1, w);
  for (int which = 2; which < 20; ++which) {
    v += mode(which, w) / which;
  }
  assign(*state.v, v); // u = a = 0: in balance
  const double before = energy(state);
  for (int n = 0; n < 200; ++n) {
    advance(stepper, state, n % 3);
    ASSERT_NEAR(energy(state) / before, 1, 1e-11) << "step " << n;
  }
}

TEST_P(UndampedModes, AreDampedByBackwardEuler)
{
  for (double w_dt : {0.05, 2.}) {
    double w = 0;
    mode(3, w);
    const Complex factor = factorOf(dynamics::RateUpdate::backwardEuler(), Complex(0, w), w_dt / w);
    EXPECT_NEAR(std::abs(factor), 1 / std::sqrt(1 + w_dt * w_dt), 1e-14);
    expectFactor(dynamics::RateUpdate::backwardEuler(), 3, w_dt, 60);
  }
}

TEST_P(DampedModes, DecayAsTheyShould)
{
  for (double w_dt : {0.02, 1., 10.}) {
    for (int which : {2, 7}) {
      expectFactor(dynamics::RateUpdate::newmark(0.25), which, w_dt, 60);
      expectFactor(dynamics::RateUpdate::backwardEuler(), which, w_dt, 60);
    }
  }
}
} // namespace asperity::verification
