#include "io/files/RunJournal.hpp"
#include "unit/io/Support.hpp"

using namespace asperity;
using test::world;

TEST(RunJournal, WritesALineForEachEvent)
{
  test::TemporaryDirectory directory;
  {
    io::RunJournal journal(directory / "run.jsonl", false, *world());
    journal.at(7, 0.5);
    io::Progress progress;
    progress.wall_time = 12.5;
    progress.peak_slip_rate = 1e-9;
    journal.progress(progress);
    progress.num_events = 3;
    progress.left = {60, true};
    journal.progress(progress);
    journal.warn({"rises of J", "a \"word\""});
    journal.end("stopped", 4, "", 13.5);
    EXPECT_EQ(journal.topics().count("rises of J"), 1u);
  }
  world()->barrier();
  const std::string text = test::contents(directory / "run.jsonl");
  const std::string expected =
    "{\"event\": \"progress\", \"step\": 7, \"time\": 0.5, \"wall_time\": 12.5, "
    "\"peak_slip_rate\": 1e-09}\n"
    "{\"event\": \"progress\", \"step\": 7, \"time\": 0.5, \"wall_time\": 12.5, "
    "\"peak_slip_rate\": 1e-09, \"events\": 3, \"seconds_left\": 60, \"knows_cycles\": true}\n"
    "{\"event\": \"warning\", \"step\": 7, \"time\": 0.5, \"topic\": \"rises of J\", "
    "\"text\": \"a \\\"word\\\"\"}\n"
    "{\"event\": \"end\", \"step\": 7, \"time\": 0.5, \"how\": \"stopped\", \"exit_status\": 4, "
    "\"message\": \"\", \"wall_time\": 13.5}\n";
  EXPECT_EQ(text.substr(text.find('\n') + 1), expected);
}
