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
  return test::refusal([&] { io::prepareOutputDirectory(directory, existing, *world()); });
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
  test::expectParts(message, {"--overwrite", "--output DIR"});
  EXPECT_EQ(everything(directory.path()), before);
}

TEST(OutputDirectory, OneSegmentIsAResult)
{
  test::TemporaryDirectory directory;
  test::onRankZero([&] { fs::create_directory(directory / "segments"); });
  test::write(directory / "segments/surface_000000.h5", "x");
  test::expectParts(refusal(directory.path()), {"surface_000000.h5"});
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
  test::expectParts(refusal(directory / "file"), {"cannot be made"});
  test::expectParts(refusal(directory / "file/below"), {"cannot be made"});
  EXPECT_EQ(test::contents(directory / "file"), "text");
  test::expectParts(refusal(""), {"is empty"});
  if (fs::is_directory("/proc/self")) { // nobody can write there, root neither
    test::expectParts(refusal("/proc/self"), {"cannot be written"});
  }
}

TEST(OutputDirectory, ALinkInThePlaceOfAFileIsRefusedAndNotFollowed)
{
  test::TemporaryDirectory directory;
  test::write(directory / "precious.txt", "mine");
  for (auto const& name : {"run.log", "checkpoint.h5.part", "steps.csv", "fault.xdmf", ".lock"}) {
    for (auto const& target : {"precious.txt", "none.txt"}) {
      const auto output = directory / "output";
      test::onRankZero([&] {
        fs::create_directory(output);
        fs::create_symlink(directory / target, output / name);
      });
      for (const auto existing : {ExistingResult::refuse, ExistingResult::keep}) {
        const auto message = refusal(output, existing);
        test::expectParts(message, {std::string(name) + " is a link"});
      }
      EXPECT_EQ(test::contents(directory / "precious.txt"), "mine") << name;
      EXPECT_FALSE(fs::exists(directory / "none.txt")) << name;
      test::onRankZero([&] { fs::remove_all(output); });
    }
  }
}

TEST(OutputDirectory, ALinkInThePlaceOfAFolderIsRefusedAndNotFollowed)
{
  test::TemporaryDirectory directory;
  makeResult(directory / "other");
  const auto before = everything(directory / "other");
  test::onRankZero([&] {
    fs::create_directory(directory / "output");
    fs::create_directory_symlink(directory / "other/segments", directory / "output/segments");
  });
  for (const auto existing : {ExistingResult::refuse, ExistingResult::keep}) {
    const auto message = refusal(directory / "output", existing);
    test::expectParts(message, {"segments is a link"});
  }
  prepare(directory / "output", ExistingResult::overwrite);
  EXPECT_FALSE(fs::is_symlink(directory / "output/segments"));
  EXPECT_EQ(everything(directory / "other"), before);
}

TEST(OutputDirectory, OverwriteRemovesLinksAndNotWhatTheyLeadTo)
{
  test::TemporaryDirectory directory;
  test::write(directory / "precious.txt", "mine");
  const auto output = directory / "output";
  test::onRankZero([&] {
    fs::create_directories(output / "segments");
    fs::create_symlink(directory / "precious.txt", output / "run.log");
    fs::create_symlink(directory / "none.txt", output / "steps.csv");
    fs::create_symlink(directory / "precious.txt", output / "segments/fault_geometry.h5.part");
  });
  prepare(output, ExistingResult::overwrite);
  EXPECT_TRUE(fs::is_empty(output));
  EXPECT_EQ(test::contents(directory / "precious.txt"), "mine");
}

TEST(OutputDirectory, TheDirectoryItselfMayBeALink)
{
  test::TemporaryDirectory directory;
  test::onRankZero([&] {
    fs::create_directory(directory / "disk");
    fs::create_directory_symlink(directory / "disk", directory / "output");
  });
  prepare(directory / "output", ExistingResult::refuse);
  prepare(directory / "output/", ExistingResult::keep);
}

TEST(OutputDirectory, AFileInThePlaceOfTheLockIsRefusedAndUntouched)
{
  test::TemporaryDirectory directory;
  test::write(directory / ".lock", "mine, of some length");
  test::expectParts(refusal(directory.path()), {".lock is another file"});
  test::expectParts(refusal(directory.path(), ExistingResult::overwrite), {".lock is"});
  EXPECT_EQ(test::contents(directory / ".lock"), "mine, of some length");
  world()->barrier();
  test::write(directory / ".lock", "process 4711 on node12\n"); // of a run that was killed
  prepare(directory.path(), ExistingResult::refuse);
  EXPECT_TRUE(fs::is_empty(directory.path()));
}

TEST(OutputDirectory, APathsPartThatIsTooLongIsRefused)
{
  test::TemporaryDirectory directory;
  const std::string part(256, 'x');
  for (auto const& name : {part, part + "/results", "results/" + part}) {
    test::expectParts(refusal(directory / name), {"File name too long"});
  }
}
