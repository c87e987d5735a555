#include "ChainOfSprings.hpp"
#include "multigrid/FloatConjugateGradients.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace asperity::multigrid
{
using namespace multigrid::test;

namespace
{
constexpr std::size_t num_coarsest = num_nodes / width; // rows of the coarsest level

// x = 0, 1, 2, ...
void fill(NodeView const& x)
{
  Kokkos::parallel_for(
    "asperity::test::fill", RangePolicy(0, x.extent_int(0)), KOKKOS_LAMBDA(int i) { x(i) = i; });
}

std::size_t largestCopy()
{
  auto const& bytes = asperity::test::copies();
  return bytes.empty() ? 0 : *std::max_element(bytes.begin(), bytes.end());
}
} // namespace

TEST(SeparateMemory, IsNotForTheHost)
{
  const NodeView x("x", 3);
  EXPECT_DEATH(x(0) = 1, "outside a kernel");
  fill(x);
  asperity::test::copies().clear();
  EXPECT_EQ(toVector(x), std::vector<double>({0, 1, 2}));
  EXPECT_EQ(asperity::test::copies(), std::vector<std::size_t>{3 * sizeof(double)});
}

// A vector of the coarsest level to its solver and back in each cycle, and the scalars of an
// iteration; its matrix when H changes. The finest level has three times as many rows.
TEST(SeparateMemory, NoMoreThanTheCoarsestLevelGoesToTheHost)
{
  const Chain chain;
  const NodeView c("c", num_nodes);
  const auto r = Chain::force(0);
  const auto given = Chain::onNodes(r);
  FloatConjugateGradients gradients(*chain.cycle, [](double*, int) {});

  asperity::test::copies().clear();
  chain.cycle->setCoarseBlocks(chain.H);
  ASSERT_TRUE(chain.cycle->setup(chain.H, chain.removed));
  const auto entries = chain.hierarchy->levels().back().terms[0].extent(0);
  EXPECT_GT(largestCopy(), 0u);
  EXPECT_LE(largestCopy(), entries * sizeof(float));

  asperity::test::copies().clear();
  const auto result = gradients.solve(given, r.norm(), 1e-3, 100, c);
  ASSERT_TRUE(result.converged);
  EXPECT_LE(largestCopy(), num_coarsest * sizeof(float));
  const auto all = std::accumulate(asperity::test::copies().begin(), asperity::test::copies().end(),
                                   std::size_t(0));
  const std::size_t cycles = result.iterations + 1; // the last one may go unused
  constexpr std::size_t scalars = 64;               // bytes, of a reduction
  EXPECT_GE(all, result.iterations * 2 * num_coarsest * sizeof(float));
  EXPECT_LE(all, cycles * (2 * num_coarsest * sizeof(float) + scalars));
}
} // namespace asperity::multigrid
