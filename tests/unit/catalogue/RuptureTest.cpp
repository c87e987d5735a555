#include "parameters/Parameters.hpp"
#include "unit/io/Stage.hpp"

#include <cmath>
#include <limits>

using namespace asperity;
using namespace asperity::io;

namespace
{
constexpr int num_base = 5; // x = 0, 1/16, 1/4, 9/16, 1
using Rates = std::vector<double>;
using History = std::vector<Rates>; // at the times 0, 1, 2, ...
constexpr double never = std::numeric_limits<double>::quiet_NaN();

struct Fault : test::Stage
{
  explicit Fault(std::vector<double> const& prescribed = Rates(num_base, 0)) : Stage(num_base)
  {
    add("fault", "slip_rate", 1, [this](double const* x, int) { return rates[nodeAt(*x)]; });
    add("fault", "prescribed", 1, [=](double const* x, int) { return prescribed[nodeAt(*x)]; });
  }

  static int nodeAt(double x) { return static_cast<int>(std::lround(4 * std::sqrt(x))); }

  std::unique_ptr<Output> output(std::filesystem::path const& directory)
  {
    auto const& kind = OutputRegistry::instance().at("Rupture");
    ParameterList list;
    list.set("Threshold", 1e-2);
    completeAndValidate(list, *kind.validParameters(), "Test");
    return kind.make(list, context(directory));
  }

  void steps(Output& rupture, History const& history, std::size_t first, std::size_t end)
  {
    for (std::size_t i = first; i < end; ++i) {
      rates = history[i];
      rupture.write(at(static_cast<int>(i), 1, i + 1 == history.size()));
    }
  }

  Rates rates;
};

// A rupture from node 1, with 1e-4 to 1 half a step before; node 4 creeps; a second one at node 2.
const History history{{1e-4, 1e-4, 1e-4, 1e-4, 1}, {1e-4, 1, 1e-4, 1e-4, 1},
                      {1e-2, 1, 1, 1e-4, 1},       {1e-4, 1e-4, 1e-4, 1e-4, 1},
                      {1e-4, 1e-4, 1, 1e-4, 1},    {1e-4, 1e-4, 1e-4, 1e-4, 1}};
const Rates creeping{0, 0, 0, 0, 1};

void expectValues(std::filesystem::path const& file, std::string const& dataset,
                  std::vector<double> const& expected)
{
  const auto found = test::readNumbers(file, dataset);
  ASSERT_EQ(found.size(), expected.size()) << dataset;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_TRUE(std::isnan(expected[i]) ? std::isnan(found[i])
                                        : std::abs(found[i] - expected[i]) < 1e-12)
      << dataset << " " << i << ": " << found[i] << " instead of " << expected[i];
  }
}

void expectBothEvents(std::filesystem::path const& file)
{
  expectValues(file, "number", {1, 2});
  expectValues(file, "onset", {0.5, 3.5});
  expectValues(file, "rupture_time", {2, 0.5, 1.5, never, never, never, never, 3.5, never, never});
  expectValues(file, "first_rupture_time", {2, 0.5, 1.5, never, never});
}
} // namespace

TEST(Rupture, TimesOfEachEventAtEachNode)
{
  test::TemporaryDirectory directory;
  Fault fault(creeping);
  const auto rupture = fault.output(directory.path());
  fault.steps(*rupture, history, 0, history.size());
  rupture->closeSegment(0);
  rupture->finish();
  test::onRankZero([&] {
    expectBothEvents(directory / "rupture.h5");
    expectValues(directory / "rupture.h5", "threshold", {1e-2});
    expectValues(directory / "rupture.h5", "geometry/positions", {0, 1.0 / 16, 0.25, 9.0 / 16, 1});
  });
}

TEST(Rupture, AnEventInProgressAtTheEndHasARow)
{
  test::TemporaryDirectory directory;
  Fault fault(creeping);
  const auto rupture = fault.output(directory.path());
  fault.steps(*rupture, history, 0, 3);
  rupture->closeSegment(0);
  test::onRankZero([&] { expectValues(directory / "rupture.h5", "number", {}); });
  rupture->finish();
  test::onRankZero([&] {
    expectValues(directory / "rupture.h5", "rupture_time", {2, 0.5, 1.5, never, never});
  });
}

TEST(Rupture, ARestartAtAnyStepGivesTheSameTimes)
{
  for (std::size_t stop = 1; stop < history.size(); ++stop) {
    test::TemporaryDirectory directory;
    Archive archive;
    {
      Fault fault(creeping);
      const auto before = fault.output(directory.path());
      fault.steps(*before, history, 0, stop);
      before->closeSegment(0);
      before->save(archive);
      before->finish(); // stopped by a signal: a row that the restart takes back
    }
    Fault fault(creeping);
    const auto after = fault.output(directory.path());
    after->restore(archive);
    fault.steps(*after, history, stop, history.size());
    after->closeSegment(1);
    after->finish();
    test::onRankZero([&] { expectBothEvents(directory / "rupture.h5"); });
  }
}

TEST(Rupture, ARunMayBeginSeismic)
{
  test::TemporaryDirectory directory;
  Fault fault;
  const auto rupture = fault.output(directory.path());
  fault.steps(*rupture, {{0, 0, 1, 0, 0}, {0, 0, 0, 0, 0}}, 0, 2);
  rupture->closeSegment(0);
  test::onRankZero([&] {
    expectValues(directory / "rupture.h5", "onset", {0});
    expectValues(directory / "rupture.h5", "rupture_time", {never, never, 0, never, never});
  });
}
