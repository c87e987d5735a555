#include "friction/Registration.hpp"
#include "friction/Registry.hpp"
#include "friction/laws/AgeingLaw.hpp"
#include "unit/friction/StateConstants.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

#include <random>

namespace asperity::friction::test
{
// The ageing law as somebody would write it who does not know its flow map.
struct AgeingWithoutFlow : StateParameters
{
  static constexpr char const* name = "Ageing Without Flow";

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return AgeingLaw{*this}.rate(V, alpha);
  }

  KOKKOS_INLINE_FUNCTION double rateDerivative(double, double alpha) const
  {
    return -this->reference_rate / slip_distance * math::exp(-alpha);
  }

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const { return -logRatio(V); }
};
} // namespace asperity::friction::test

ASPERITY_REGISTER_STATE_LAW(asperity::friction::test::AgeingWithoutFlow)

namespace asperity::friction::test
{
namespace
{
static_assert(detail::HasFlow<AgeingLaw>::value, "the ageing law has its flow map");
static_assert(!detail::HasFlow<AgeingWithoutFlow>::value, "this one falls back on backward Euler");

std::unique_ptr<StateKernels> kernels(std::string const& law, std::size_t num_nodes)
{
  return makeStateKernels(law,
                          parametersOf(std::vector<Values>(num_nodes, {L, reference_rate, 0.})));
}

// alpha at the time 1 s after num_steps steps.
double after(std::string const& law, double V, double alpha0, int num_steps)
{
  const auto law_kernels = kernels(law, 1);
  const auto rate = toDevice(Values{V}), alpha = toDevice(Values{alpha0});
  for (int step = 0; step < num_steps; ++step) {
    EXPECT_EQ(law_kernels->flow(rate, 1.0 / num_steps, alpha, alpha), 0);
  }
  return toHost(alpha)(0);
}

TEST(BackwardEuler, ConvergesWithFirstOrderToTheFlowMap)
{
  for (const double V : {0.0, 1e-9, 1e-5, 1e-4}) {
    for (const double alpha0 : {-1.0, 0.0, 4.0}) {
      const double exact = after("Ageing", V, alpha0, 1);
      double previous = 0;
      for (const int num_steps : {200, 400, 800}) {
        const double error = std::abs(after("Ageing Without Flow", V, alpha0, num_steps) - exact);
        EXPECT_GT(error, 0);
        if (num_steps > 200) {
          EXPECT_NEAR(previous / error, 2, 0.1) << V << ' ' << alpha0 << ' ' << num_steps;
        }
        previous = error;
      }
    }
  }
}

TEST(BackwardEuler, IsStableHoweverLargeTheStep)
{
  std::mt19937 generator(5);
  const auto uniform = [&generator](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  Values V, alpha;
  for (int i = 0; i < 2000; ++i) {
    V.push_back(i % 10 == 0 ? 0 : std::pow(10, uniform(-20, 2)));
    alpha.push_back(uniform(-100, 100));
  }
  const auto law = kernels("Ageing Without Flow", V.size());
  const auto exact = lawWith<AgeingLaw>({{"L", L}, {"Reference Slip Rate", reference_rate}});
  for (const double dt : {1e-6, 1e-2, 1.0, 1e3, 1e9}) {
    const NodeView result("result", V.size());
    EXPECT_EQ(law->flow(toDevice(V), dt, toDevice(alpha), result), 0);
    const auto host = toHost(result);
    for (std::size_t i = 0; i < V.size(); ++i) {
      // It solves its equation to the rounding of the unknown, and moves towards the steady state.
      const double below = host(i) - 1e-14 * (1 + std::abs(host(i)) + std::abs(alpha[i]));
      const double above = host(i) + 1e-14 * (1 + std::abs(host(i)) + std::abs(alpha[i]));
      EXPECT_LE(below - alpha[i] - dt * exact.rate(V[i], below), 0) << V[i] << ' ' << dt;
      EXPECT_GE(above - alpha[i] - dt * exact.rate(V[i], above), 0) << V[i] << ' ' << dt;
      const double steady = exact.steadyState(V[i]);
      EXPECT_GE((host(i) - alpha[i]) * (steady - alpha[i]), 0);
      EXPECT_LE((host(i) - steady) * (steady - alpha[i]), 1e-12) << V[i] << ' ' << alpha[i];
    }
  }
}

TEST(BackwardEuler, CountsNodesThatItCannotSolve)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const NodeView result("result", 3);
  EXPECT_EQ(kernels("Ageing Without Flow", 3)
              ->flow(toDevice(Values{1e-6, nan, 1e-6}), 1, toDevice(Values{1, 2, 3}), result),
            1);
  EXPECT_EQ(toHost(result)(1), 2);
}
} // namespace
} // namespace asperity::friction::test
