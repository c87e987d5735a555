#include "io/files/RunJournal.hpp"
#include "base/Errors.hpp"
#include "io/files/RunRecord.hpp"
#include "unit/io/Support.hpp"

using namespace asperity;
using test::world;

TEST(RunJournal, WritesALineForEachEvent)
{
  test::TemporaryDirectory directory;
  {
    io::RunJournal journal(directory / "run.jsonl", false, *world());
    journal.fault({{"level", {1}}, {"strike", {0.1, 0, -1}}});
    journal.at(7, 0.5);
    io::Progress progress;
    progress.wall_time = 12.5;
    progress.peak_slip_rate = 1e-9;
    journal.progress(progress);
    progress.num_events = 3;
    progress.left = {60, true};
    journal.progress(progress);
    journal.warn({"energy increase", "a \"word\""});
    journal.end("stopped", 4, "", 13.5);
    EXPECT_EQ(journal.topics().count("energy increase"), 1u);
  }
  world()->barrier();
  const std::string text = test::contents(directory / "run.jsonl");
  const std::string expected =
    "{\"event\": \"fault\", \"step\": 0, \"time\": 0, \"level\": 1, "
    "\"strike\": [0.1, 0, -1]}\n"
    "{\"event\": \"progress\", \"step\": 7, \"time\": 0.5, \"wall_time\": 12.5, "
    "\"peak_slip_rate\": 1e-09}\n"
    "{\"event\": \"progress\", \"step\": 7, \"time\": 0.5, \"wall_time\": 12.5, "
    "\"peak_slip_rate\": 1e-09, \"events\": 3, \"seconds_left\": 60, \"knows_cycles\": true}\n"
    "{\"event\": \"warning\", \"step\": 7, \"time\": 0.5, \"topic\": \"energy increase\", "
    "\"text\": \"a \\\"word\\\"\"}\n"
    "{\"event\": \"end\", \"step\": 7, \"time\": 0.5, \"how\": \"stopped\", \"exit_status\": 4, "
    "\"message\": \"\", \"wall_time\": 13.5}\n";
  EXPECT_EQ(text.substr(text.find('\n') + 1), expected);
}

TEST(RunRecord, ARestartRepeatsTheWarningsOfTheRunBeforeUnlessTheyAreNewAgain)
{
  test::TemporaryDirectory directory;
  Archive archive, of_restart;
  {
    io::RunRecord before(directory.path(), false, *world());
    before.warn({"cohesive zone", "few cells."});
    before.at(7, 0.5);
    before.warn({"hidden growth", "1 step."});
    before.save(archive);
    before.warn({"energy increase", "after the checkpoint."});
  }
  world()->barrier();
  {
    io::RunRecord after(directory.path(), true, *world());
    after.warn({"cohesive zone", "fewer cells."});
    after.at(9, 0.75);
    after.restore(archive);
    EXPECT_EQ(after.topics(), (std::set<std::string>{"cohesive zone", "hidden growth"}));
    after.save(of_restart);
    after.end("finished", 0);
  }
  world()->barrier();
  EXPECT_EQ(of_restart.child("warnings").get<std::string>("1/text"), "1 step.");
  const std::string journal = test::contents(directory / "run.jsonl");
  const std::string of_after = journal.substr(journal.find("{\"event\": \"restart\""));
  EXPECT_EQ(of_after.find("{\"event\": \"restart\", \"step\": 9, \"time\": 0.75}\n"
                          "{\"event\": \"warning\", \"step\": 7, \"time\": 0.5, "
                          "\"topic\": \"hidden growth\", \"text\": \"1 step.\"}\n"
                          "{\"event\": \"end\", \"step\": 9, \"time\": 0.75"),
            0u)
    << of_after;
  const std::string log = test::contents(directory / "run.log");
  EXPECT_NE(log.find("has warned:\nWARNING: 1 step.\n"), std::string::npos) << log;
}

TEST(RunRecord, RepeatsNothingOfARunWithoutWarnings)
{
  test::TemporaryDirectory directory;
  Archive archive;
  io::RunRecord record(directory.path(), false, *world());
  record.save(archive);
  EXPECT_NO_THROW(record.restore(archive));
  EXPECT_TRUE(record.topics().empty());
}

TEST(RunRecord, NamesTheKindOfAFailure)
{
  const std::string text = "begin a new run";
  const auto kind = [](std::exception const& error) {
    test::TemporaryDirectory directory;
    io::RunRecord(directory.path(), false, *world()).fail(error);
    world()->barrier();
    const std::string journal = test::contents(directory / "run.jsonl");
    const auto at = journal.find("\"kind\": ");
    return at == std::string::npos ? journal : journal.substr(at + 8);
  };
  EXPECT_EQ(kind(UselessRun(text)), "\"useless_run\"}\n");
  EXPECT_EQ(kind(SolveError(text)), "\"solve\"}\n");
  EXPECT_EQ(kind(InputError(text)), "\"input\"}\n");
  EXPECT_EQ(kind(OutputError(text)), "\"output\"}\n");
  EXPECT_EQ(kind(std::runtime_error(text)), "\"other\"}\n");
}
