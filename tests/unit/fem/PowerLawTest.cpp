#include "fem/bulk/BulkLaw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Steps of rock that flows by a power law, whatever its numbers.
namespace asperity::fem
{
namespace
{
constexpr double G = 3e10;
constexpr double prefactors[] = {1e-200, 1e-94, 1e-40, 1e-24, 1e-11};
constexpr double exponents[] = {1, 1.5, 3, 10, 100};
constexpr double steps[] = {1e-3, 1, 1e10};

TensorView rowsOf(std::vector<double> const& values, int width)
{
  const TensorView view("rows", values.size() / width, width);
  auto const host = Kokkos::create_mirror_view(view);
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

// t1 of cells with the shear stresses t at the beginning of a step without strain.
std::vector<double> after(double step, double A, double n, std::vector<double> const& t)
{
  const int size = static_cast<int>(t.size());
  std::vector<double> stress, parameters;
  std::vector<int> numbers;
  for (int cell = 0; cell < size; ++cell) {
    numbers.push_back(cell);
    stress.insert(stress.end(), {0.6 * t[cell], -0.8 * t[cell]});
    parameters.insert(parameters.end(), {A, n});
  }
  const std::vector<double> none(t.size());
  const TensorView zero("zero", size, 2), inelastic("inelastic", size, 2), gamma("gamma", size, 1);
  const TensorView no_shear("no shear", size, 1);
  auto const moduli = toDevice(std::vector<double>(t.size(), G), "moduli");
  auto const no_modulus = toDevice(none, "none");
  bulkLaws()
    .at("Power Law")
    .make_kernel(rowsOf(parameters, 2))({toDevice(numbers, "cells"),
                                         moduli,
                                         no_modulus,
                                         rowsOf(stress, 2),
                                         no_modulus,
                                         zero,
                                         zero,
                                         no_shear,
                                         {},
                                         0,
                                         step,
                                         inelastic,
                                         gamma,
                                         {},
                                         NodeView("trial", size)});
  auto const e = toHost(ConstTensorView(inelastic));
  std::vector<double> result;
  for (int cell = 0; cell < size; ++cell) {
    result.push_back(t[cell] - 2 * G * std::hypot(e(cell, 0), e(cell, 1)));
  }
  return result;
}

std::vector<double> stresses()
{
  std::vector<double> t;
  for (double exponent = -3; exponent < 12; exponent += 0.05) {
    t.push_back(std::pow(10., exponent));
  }
  return t;
}

template <class Check>
void forAll(Check const& check)
{
  for (const double A : prefactors) {
    for (const double n : exponents) {
      for (const double step : steps) {
        SCOPED_TRACE(testing::Message() << "A = " << A << ", n = " << n << ", step " << step);
        check(A, n, step);
      }
    }
  }
}

// t1 / t of t1 + 2 G A tau t1^n = t, by bisection.
double share(double A, double n, double step, double t)
{
  const double flow = std::log(2 * G) + std::log(A) + std::log(step) + (n - 1) * std::log(t);
  double low = 0, high = 1;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (middle + std::exp(flow + n * std::log(middle)) < 1 ? low : high) = middle;
  }
  return low;
}
} // namespace

// The sum of logarithms is up to 4000, which rounding reaches.
TEST(PowerLaw, IsAStepOfBackwardEuler)
{
  auto const t = stresses();
  forAll([&](double A, double n, double step) {
    auto const t1 = after(step, A, n, t);
    for (std::size_t i = 0; i < t.size(); ++i) {
      EXPECT_NEAR(t1[i] / t[i], share(A, n, step, t[i]), 2e-12);
    }
  });
}

// The stress is the gradient of a convex potential that is no stiffer than that of elastic rock.
TEST(PowerLaw, HasASlopeFromZeroToOne)
{
  auto const t = stresses();
  forAll([&](double A, double n, double step) {
    auto const t1 = after(step, A, n, t);
    for (std::size_t i = 1; i < t.size(); ++i) {
      const double rise = t1[i] - t1[i - 1], rounding = 1e-12 * t[i];
      EXPECT_GE(rise, -rounding);
      EXPECT_LE(rise, t[i] - t[i - 1] + rounding);
    }
  });
}

TEST(PowerLaw, IsElasticWhereNothingFlows)
{
  const std::vector<double> t = {0, 1e-3, 1e8};
  EXPECT_EQ(after(1e10, 0, 3, t), t);
  EXPECT_EQ(after(infinity, 1e-24, 3, t), t); // what the rock bears at the start of a run
  EXPECT_EQ(after(1e-3, 1e-200, 3, t), t);
}
} // namespace asperity::fem
