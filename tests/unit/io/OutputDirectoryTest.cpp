#include "io/files/OutputDirectory.hpp"
#include "unit/io/Support.hpp"

#include <map>
#include <unistd.h>

using namespace asperity;
using io::ExistingResult;
using test::world;

namespace
{
namespace fs = std::filesystem;

// Every file below the directory with its contents.
std::map<std::string, std::string> everything(fs::path const& directory)
{
  std::map<std::string, std::string> files;
  for (auto const& entry : fs::recursive_directory_iterator(directory)) {
    files[entry.path().string()] = entry.is_regular_file() ? test::contents(entry.path()) : "";
  }
  return files;
}

void makeResult(fs::path const& directory)
{
  test::onRankZero([&] { fs::create_directories(directory / "segments"); });
  for (auto const& name : {"run.log", "fault.h5", "steps.csv", "segments/fault_000001.h5",
                           "segments/volume_1234567.h5", "checkpoint.h5.part"}) {
    test::write(directory / name, name);
  }
}

// Until rank 0 has given the lock back, whose file the other ranks might see otherwise.
void prepare(fs::path const& directory, ExistingResult existing)
{
  io::prepareOutputDirectory(directory, existing, *world());
  world()->barrier();
}

std::string refusal(fs::path const& directory, ExistingResult existing = ExistingResult::refuse)
{
  return test::inputError([&] { io::prepareOutputDirectory(directory, existing, *world()); });
}
} // namespace

TEST(OutputDirectory, IsMadeWithItsParents)
{
  test::TemporaryDirectory directory;
  prepare(directory / "a/b", ExistingResult::refuse);
  EXPECT_TRUE(fs::is_directory(directory / "a/b"));
  EXPECT_TRUE(fs::is_empty(directory / "a/b"));
}

TEST(OutputDirectory, ForeignFilesAreNoResult)
{
  test::TemporaryDirectory directory;
  test::write(directory / "notes.txt", "mine");
  prepare(directory.path(), ExistingResult::refuse);
  EXPECT_EQ(test::contents(directory / "notes.txt"), "mine");
}

TEST(OutputDirectory, ExistingResultIsRefusedAndUntouched)
{
  test::TemporaryDirectory directory;
  makeResult(directory.path());
  const auto before = everything(directory.path());
  world()->barrier();
  const auto message = refusal(directory.path());
  EXPECT_TRUE(test::contains(message, "--overwrite")) << message;
  EXPECT_TRUE(test::contains(message, "--output DIR")) << message;
  EXPECT_EQ(everything(directory.path()), before);
}

TEST(OutputDirectory, OneSegmentIsAResult)
{
  test::TemporaryDirectory directory;
  test::onRankZero([&] { fs::create_directory(directory / "segments"); });
  test::write(directory / "segments/surface_000000.h5", "x");
  EXPECT_TRUE(test::contains(refusal(directory.path()), "surface_000000.h5"));
}

TEST(OutputDirectory, OverwriteRemovesOnlyWhatARunWrites)
{
  test::TemporaryDirectory directory;
  makeResult(directory.path());
  test::write(directory / "notes.txt", "mine");
  test::write(directory / "segments/notes_12.h5", "mine");
  prepare(directory.path(), ExistingResult::overwrite);
  const std::map<std::string, std::string> expected{
    {(directory / "notes.txt").string(), "mine"},
    {(directory / "segments").string(), ""},
    {(directory / "segments/notes_12.h5").string(), "mine"}};
  EXPECT_EQ(everything(directory.path()), expected);
}

TEST(OutputDirectory, RestartKeepsEverything)
{
  test::TemporaryDirectory directory;
  makeResult(directory.path());
  const auto before = everything(directory.path());
  world()->barrier();
  prepare(directory.path(), ExistingResult::keep);
  EXPECT_EQ(everything(directory.path()), before);
}

TEST(OutputDirectory, WhatCannotBeMadeOrWrittenIsRefused)
{
  test::TemporaryDirectory directory;
  test::write(directory / "file", "text");
  EXPECT_TRUE(test::contains(refusal(directory / "file"), "cannot be made"));
  EXPECT_TRUE(test::contains(refusal(directory / "file/below"), "cannot be made"));
  EXPECT_EQ(test::contents(directory / "file"), "text");
  EXPECT_TRUE(test::contains(refusal(""), "is empty"));
  if (fs::is_directory("/proc/self")) { // nobody can write there, root neither
    EXPECT_TRUE(test::contains(refusal("/proc/self"), "cannot be written"));
  }
}
