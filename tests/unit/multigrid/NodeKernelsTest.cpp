#include "multigrid/NodeKernels.hpp"

#include "multigrid/Arrays.hpp"

#include <gtest/gtest.h>

namespace asperity::multigrid
{
TEST(NodeKernels, MultipliesBlocksOfAllSizes)
{
  const auto check = [](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    const auto a = makeNumbers<HostBlocks>(R * C), x = makeNumbers<HostBlocks>(C);
    const auto y = makeNumbers<HostBlocks>(R), sum = makeNumbers<HostBlocks>(C);
    Kokkos::deep_copy(sum, 1.f);
    for (int i = 0; i < R * C; ++i) {
      a[i] = static_cast<float>(1 + i);
    }
    for (int c = 0; c < C; ++c) {
      x[c] = static_cast<float>(2 + c);
    }
    RowSums<R, C> product;
    product.add(a.data(), x.data());
    for (int r = 0; r < R; ++r) {
      float expected = 0;
      for (int c = 0; c < C; ++c) {
        expected += a[r * C + c] * x[c];
      }
      EXPECT_EQ(product[r], expected) << R << ' ' << C;
      y[r] = static_cast<float>(3 + r);
    }
    addTransposed<R, C>(a.data(), y.data(), sum.data());
    for (int c = 0; c < C; ++c) {
      float expected = 1;
      for (int r = 0; r < R; ++r) {
        expected += a[r * C + c] * y[r];
      }
      EXPECT_EQ(sum[c], expected) << R << ' ' << C;
    }
  };
  using One = std::integral_constant<int, 1>;
  using Two = std::integral_constant<int, 2>;
  using Three = std::integral_constant<int, 3>;
  using Four = std::integral_constant<int, 4>;
  using Six = std::integral_constant<int, 6>;
  check(One(), One());
  check(Two(), Two());
  check(Two(), Three());
  check(Three(), Three());
  check(Three(), Four());
  check(Three(), Six());
  check(Four(), Four());
  check(Six(), Six());
}

TEST(NodeKernels, InvertsInTheFreeComponents)
{
  double a[3][3] = {{4, 1, 2}, {1, 3, 0}, {2, 0, 5}};
  float inverse[9];
  invertFree(
    a, [](int c) { return c != 1; }, inverse);
  // The inverse of {{4, 2}, {2, 5}} is {{5, -2}, {-2, 4}} / 16.
  const float expected[9] = {5 / 16.f, 0, -2 / 16.f, 0, 0, 0, -2 / 16.f, 0, 4 / 16.f};
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(inverse[i], expected[i], 1e-7) << i;
  }
  double singular[2][2] = {{1, 1}, {1, 1}};
  invertFree(
    singular, [](int) { return true; }, inverse);
  EXPECT_EQ(inverse[0], 1);
  EXPECT_EQ(inverse[1] == 0 && inverse[2] == 0 && inverse[3] == 0, true);
}
} // namespace asperity::multigrid
