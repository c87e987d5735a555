#include "io/files/RunLog.hpp"
#include "unit/io/Support.hpp"

using namespace asperity;
using io::Progress;
using io::RunLog;
using test::world;

namespace
{
Progress at(double time, double wall_time = 0)
{
  Progress progress;
  progress.time = time;
  progress.final_time = 100;
  progress.step_size = 0.25;
  progress.peak_slip_rate = 5.1e-5;
  progress.step = 17;
  progress.fixed_point_iterations = 3;
  progress.num_events = 2;
  progress.wall_time = wall_time;
  return progress;
}

std::size_t countOf(std::string const& text, std::string const& part)
{
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

// What a run of 1000 steps of 0.01 s of wall time shows and logs; nothing on ranks other than 0.
struct Shown
{
  Shown(RunLog::Style const& style)
  {
    {
      RunLog log(directory / "run.log", false, *world(), terminal, style);
      log.message("begin");
      for (int step = 0; step <= 1000; ++step) {
        num_due += log.progress(at(0.1 * step, 0.01 * step)) ? 1 : 0;
      }
      log.message("end");
    }
    world()->barrier();
    file = test::contents(directory / "run.log");
  }
  test::TemporaryDirectory directory;
  std::ostringstream terminal;
  std::string file;
  int num_due = 0;
};
} // namespace

TEST(RunLog, WithoutATerminalALineNowAndThen)
{
  const Shown shown((RunLog::Style()));
  EXPECT_EQ(countOf(shown.file, "\n"), 22u) << shown.file; // 20 times 5 %, two messages
  test::expectParts(shown.file, {"t = 50 s of 100 s (50 %), step 17, dt 0.25 s, "
                                 "V 5.1e-05 m/s, 3 iterations, 2 events, wall 5 s\n"});
  EXPECT_EQ(shown.num_due, world()->getRank() == 0 ? 20 : 0);
  EXPECT_EQ(shown.terminal.str(), world()->getRank() == 0 ? shown.file : "");
}

TEST(RunLog, SaysWhetherTheTimeLeftKnowsPastCycles)
{
  test::TemporaryDirectory directory;
  std::ostringstream terminal;
  {
    RunLog log(directory / "run.log", false, *world(), terminal, RunLog::Style());
    log.progress(at(0));
    auto progress = at(50);
    progress.left = {7200, false};
    log.progress(progress);
    progress = at(90);
    progress.left = {600, true};
    log.progress(progress);
  }
  world()->barrier();
  const std::string text = test::contents(directory / "run.log");
  test::expectParts(text,
                    {", wall 0 s, 2 h left at this speed\n", ", wall 0 s, about 10 min left\n"});
}

// Three in each 5 %: after 0.2 s, after 0.4 s, and at its end after 0.5 s.
TEST(RunLog, LinesComeByWallTimeToo)
{
  RunLog::Style impatient;
  impatient.seconds_per_line = 0.195;
  EXPECT_EQ(countOf(Shown(impatient).file, "\n"), 2u + 60u);
}

TEST(RunLog, OnATerminalOneLineIsRewritten)
{
  RunLog::Style style;
  style.in_place = true;
  style.width = 40;
  style.seconds_per_update = 0;
  const Shown shown(style);
  EXPECT_EQ(countOf(shown.file, "\n"), 22u);
  if (world()->getRank() > 0) {
    return;
  }
  const std::string text = shown.terminal.str();
  EXPECT_EQ(countOf(text, "\n"), 2u); // the messages
  test::expectParts(text, {"\r 50% t=50 s dt=0.25 V=5.1e-05 it=3 e"});
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find_first_of("\r\n", begin);
    EXPECT_LT(text.substr(begin, end - begin).size(), 40u);
  }
}

TEST(RunLog, OnATerminalUpdatesAreLimitedInTime)
{
  RunLog::Style style;
  style.in_place = true;
  style.seconds_per_update = 1e6;
  const Shown shown(style);
  EXPECT_EQ(countOf(shown.terminal.str(), "% t="), world()->getRank() == 0 ? 1u : 0u);
}

TEST(RunLog, ARestartAppends)
{
  test::TemporaryDirectory directory;
  std::ostringstream terminal;
  for (const bool append : {false, true}) {
    RunLog log(directory / "run.log", append, *world(), terminal, RunLog::Style());
    log.message(append ? "second" : "first");
  }
  world()->barrier();
  EXPECT_EQ(test::contents(directory / "run.log"), "first\nsecond\n");
}

TEST(RunLog, AFileThatCannotBeOpenedIsRefusedOnEveryRank)
{
  std::ostringstream terminal;
  const RunLog::Style style;
  EXPECT_THROW(RunLog("/proc/none/run.log", false, *world(), terminal, style), InputError);
}
