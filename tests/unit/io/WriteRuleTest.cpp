#include "io/WriteRule.hpp"
#include "unit/io/Support.hpp"

#include <cmath>

using namespace asperity;
using io::StepInfo;
using io::WriteRule;

namespace
{
ParameterList parameters(int every, double factor, std::vector<double> const& times = {})
{
  Declare declared;
  WriteRule::declare(declared, every, factor);
  ParameterList list;
  list.set("Times", Teuchos::Array<double>(times));
  completeAndValidate(list, *declared.list(), "Test");
  return list;
}

using Rows = std::vector<int>;

// The steps with a row among first, ..., end - 1 of a run whose step i is at time i.
Rows rows(WriteRule& rule, std::vector<double> const& rates, std::size_t first, std::size_t end)
{
  Rows written;
  for (std::size_t i = first; i < end; ++i) {
    const bool is_last = i + 1 == rates.size();
    const StepInfo step{static_cast<std::int64_t>(i), double(i), 1, rates[i], is_last};
    if (rule.isDue(step)) {
      written.push_back(static_cast<int>(i));
    }
  }
  return written;
}

Rows rows(WriteRule& rule, std::vector<double> const& rates)
{
  return rows(rule, rates, 0, rates.size());
}
} // namespace

TEST(WriteRule, FirstAndLastAlways)
{
  WriteRule rule(parameters(0, 0));
  EXPECT_EQ(rows(rule, std::vector<double>(8, 1.0)), (Rows{0, 7}));
}

TEST(WriteRule, EveryNSteps)
{
  WriteRule rule(parameters(3, 0));
  EXPECT_EQ(rows(rule, std::vector<double>(9, 1.0)), (Rows{0, 3, 6, 8}));
}

TEST(WriteRule, ByTheFactorSinceTheLastRowUpAndDown)
{
  WriteRule rule(parameters(0, 2));
  EXPECT_EQ(rows(rule, {1, 1.5, 2.5, 4, 6, 2.9, 2.9, 2.9}), (Rows{0, 2, 4, 5, 7}));
  WriteRule at_rest(parameters(0, 2));
  EXPECT_EQ(rows(at_rest, {0, 0, 1e-300, 1e-300, 0, 0}), (Rows{0, 2, 4, 5}));
}

TEST(WriteRule, AtTimes)
{
  WriteRule rule(parameters(0, 0, {4, 2.5, 2.7}));
  EXPECT_EQ(rows(rule, std::vector<double>(9, 1.0)), (Rows{0, 3, 4, 8}));
}

TEST(WriteRule, AtMultiplesOfAnInterval)
{
  auto list = parameters(0, 0);
  list.set("Every Seconds", 2.5); // passed by the steps 3, 5 and 8
  WriteRule rule(list);
  EXPECT_EQ(rows(rule, std::vector<double>(10, 1.0)), (Rows{0, 3, 5, 8, 9}));
}

TEST(WriteRule, MoreOftenWhileTheFaultRuptures)
{
  auto list = parameters(0, 0);
  list.set("Every Seconds", 5.0);
  list.set("Every Seconds of Rupture", 1.5); // 1.5, 3, 4.5, 6, 7.5
  list.set("Rupture Rate", 0.1);
  WriteRule rule(list);
  EXPECT_EQ(rows(rule, {0, 0, 0, 0.1, 0, 0, 0.2, 0.2, 0.2, 0, 0, 0}),
            (Rows{0, 3, 5, 6, 8, 10, 11}));
}

TEST(WriteRule, ARestartGoesOnAlike)
{
  const std::vector<double> rates{1, 1, 3, 3, 3, 3, 9, 9, 9, 9, 9};
  auto list = parameters(4, 2, {7.5});
  list.set("Every Seconds", 4.5);
  WriteRule whole(list);
  const Rows expected = rows(whole, rates);
  EXPECT_EQ(expected, (Rows{0, 2, 5, 6, 8, 9, 10}));
  for (std::size_t stop = 1; stop < rates.size(); ++stop) {
    WriteRule before(list), after(list);
    Rows written = rows(before, rates, 0, stop);
    Archive archive;
    before.save(archive);
    after.restore(archive);
    for (const int row : rows(after, rates, stop, rates.size())) {
      written.push_back(row);
    }
    EXPECT_EQ(written, expected) << "stopped before step " << stop;
  }
}
