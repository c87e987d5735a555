#include "friction/Registry.hpp"
#include "friction/laws/RateWeakening.hpp"
#include "friction/laws/RegularisedLaw.hpp"
#include "friction/laws/TabulatedLaw.hpp"
#include "unit/friction/Reference.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace asperity::friction::test
{
namespace
{
// A table that the host reads.
class HostTable
{
public:
  HostTable(Values const& x, Values const& f)
      : points_(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), makeTable(x, f)))
  {
  }
  Table get() const { return {points_.data(), points_.extent_int(0)}; }
  double operator()(double x) const { return get()(x); }

private:
  decltype(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), TableView())) points_;
};

// count + 1 values from first to last
Values range(double first, double last, int count)
{
  Values result;
  for (int i = 0; i <= count; ++i) {
    result.push_back(first + (last - first) * i / count);
  }
  return result;
}

TEST(Table, PassesThroughItsPointsWithoutOvershoot)
{
  const Values x{-3, -2.5, -1, 0, 0.1, 2, 7}, f{1, 0.9, 0.9, 0.2, 0.19, 0.5, 0.55};
  const HostTable table(x, f);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_DOUBLE_EQ(table(x[i]), f[i]);
  }
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double sign = f[i] < f[i - 1] ? -1 : 1;
    double before = f[i - 1];
    for (const double at : range(x[i - 1], x[i], 200)) {
      EXPECT_GE(sign * (table(at) - before), -1e-15) << at;
      before = table(at);
    }
  }
  EXPECT_EQ(table(-4), 1);
  EXPECT_EQ(table(-infinity), 1);
  EXPECT_EQ(table(8), 0.55);
}

TEST(Table, HasAParabolaExactly)
{
  Values f;
  const Values x{1, 1.2, 1.7, 2, 2.1, 3};
  for (const double at : x) {
    f.push_back(3 - at * at);
  }
  const HostTable table(x, f);
  for (const double at : range(1, 3, 50)) {
    EXPECT_NEAR(table(at), 3 - at * at, 1e-14);
  }
  EXPECT_DOUBLE_EQ(HostTable({0, 2}, {1, 5})(0.5), 2);
}

TEST(Table, RefusesWhatIsNoFunction)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(makeTable({1}, {1}), std::invalid_argument);
  EXPECT_THROW(makeTable({1, 2}, {1}), std::invalid_argument);
  EXPECT_THROW(makeTable({1, 1}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(makeTable({1, 2}, {1, nan}), std::invalid_argument);
  EXPECT_THROW(makeTable({1, infinity}, {1, 2}), std::invalid_argument);
}

// SCEC's TPV103.
constexpr double a = 0.01, b = 0.014, L = 0.4, V_ref = 1e-6, mu_ref = 0.6;
const std::map<std::string, double> common = {{"a", a},
                                              {"b", b},
                                              {"L", L},
                                              {"Reference Slip Rate", V_ref},
                                              {"Reference Friction Coefficient", mu_ref}};
// f_w = 0.2 and V_w = 0.1 m/s are the defaults.
const auto weakening = lawWith<StrongRateWeakeningLaw>(common);
const auto friction_law = lawWith<RegularisedLaw>(common);

TabulatedLaw tabulated(Table const& table)
{
  auto law = lawWith<TabulatedLaw>(common);
  law.table = table;
  return law;
}

// Its steady friction in steps of h in log10 V, as a table.
HostTable sampled(double h)
{
  Values f;
  const auto x = range(-17, 2, static_cast<int>(std::lround(19 / h)));
  for (const double at : x) {
    const double V = std::pow(10, at);
    f.push_back(friction_law.at(weakening.steadyState(V)).mu(V));
  }
  return {x, f};
}

// The largest difference in psi = mu* + b alpha.
double errorOf(double h)
{
  const auto table = sampled(h);
  const auto law = tabulated(table.get());
  double result = 0;
  for (const double at : range(-16.9, 1.9, 30011)) {
    const double V = std::pow(10, at);
    result = std::max(result, b * std::abs(law.steadyState(V) - weakening.steadyState(V)));
  }
  return result;
}

// Friction falls by 0.3 within 0.05 of log10 V, so that h^3 f''' / 50 is about 4e-5 at h = 0.01.
TEST(Tabulated, IsTheLawOfWhichItIsATable)
{
  const double fine = errorOf(0.01);
  EXPECT_LT(fine, 5e-4);
  EXPECT_GT(errorOf(0.02) / fine, 5.6); // 8 in the limit
}

TEST(Tabulated, FlowsTowardsItsSteadyState)
{
  const auto table = sampled(0.1);
  const auto law = tabulated(table.get());
  for (const double V : {1e-16, 1e-6, 0.2, 5.0}) {
    const double steady = law.steadyState(V), dt = 0.3 * L / V;
    EXPECT_NEAR(law.flow(V, dt, steady + 2), steady + 2 * std::exp(-0.3), 1e-12);
    EXPECT_NEAR(law.rate(V, steady + 2), -2 * V / L, 1e-12 * V / L);
  }
  EXPECT_EQ(law.flow(0, 1e9, 17), 17);
}

TEST(Tabulated, IsMadeOfATable)
{
  const auto parameters = parametersOf({{a, b, L, V_ref, mu_ref}, {a, b, L, V_ref, mu_ref}});
  EXPECT_THROW(makeStateKernels("Tabulated", parameters), std::invalid_argument);
  const Values x{-9, 0}, f{0.7, 0.4};
  const HostTable table(x, f);
  const auto law = tabulated(table.get());
  const auto kernels = makeStateKernels("Tabulated", parameters, makeTable(x, f));
  const NodeView alpha("alpha", 2);
  kernels->steadyState(toDevice(Values{1e-7, 1e-3}), alpha);
  const auto host = toHost(alpha);
  EXPECT_EQ(host(0), law.steadyState(1e-7));
  EXPECT_EQ(host(1), law.steadyState(1e-3));
}
} // namespace
} // namespace asperity::friction::test
