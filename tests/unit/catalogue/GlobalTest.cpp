#include "parameters/Parameters.hpp"
#include "unit/io/Stage.hpp"

#include <cmath>

using namespace asperity;
using namespace asperity::io;

namespace
{
constexpr int num_base = 3; // x = 0, 1/4, 1 with the weights 1/8, 1/2, 3/8

struct Fault : test::Stage
{
  Fault() : Stage(num_base)
  {
    add("fault", "slip_rate", 1, [this](double const* x, int) { return (1 + time) * (1 + x[0]); });
    add("fault", "slip", 2, [this](double const*, int c) { return (c == 0 ? 3 : -4) * time; });
    add("fault", "shear_modulus", 1, [](double const* x, int) { return 1e6 * (1 + x[0]); });
    add("fault", "prescribed", 1, [](double const* x, int) { return x[0] == 1 ? 1 : 0; });
  }
};

void run(std::filesystem::path const& directory)
{
  Fault fault;
  auto const& kind = OutputRegistry::instance().at("Global");
  ParameterList list;
  completeAndValidate(list, *kind.validParameters(), "Test");
  const auto global = kind.make(list, fault.context(directory));
  for (int step = 0; step < 3; ++step) {
    global->write(fault.at(step, 2));
  }
  global->closeSegment(0);
  global->finish();
}
} // namespace

TEST(Global, MomentsOfWhatFrictionMoves)
{
  test::TemporaryDirectory directory;
  run(directory.path());
  test::onRankZero([&] {
    // moment rate: 1e6 (1/8 + 1/2 * 1.25^2) (1 + t); moment: 1e6 (1/8 + 1/2 * 1.25) 5 t
    EXPECT_EQ(test::contents(directory / "global.csv"),
              "time [s],peak_slip_rate [m/s],moment_rate_per_length [N/s],moment_per_length [N]\n"
              "0,1.25,906250,0\n"
              "2,3.75,2718750,7500000\n"
              "4,6.25,4531250,15000000\n");
  });
}
