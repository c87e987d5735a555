#include "io/CsvFile.hpp"
#include "unit/io/Support.hpp"

#include <cmath>
#include <limits>

using namespace asperity;
using io::Archive;
using io::CsvFile;
using test::world;

namespace
{
// Two rows, a checkpoint, a third row on disk, then the end without a word.
Archive killedAfterCheckpoint(std::filesystem::path const& path)
{
  CsvFile file(path, "a,b", world());
  file.writeRow("1,2");
  file.writeRow("3,4");
  file.flush();
  Archive archive;
  file.save(archive);
  file.writeRow("5,6");
  file.flush();
  return archive;
}
} // namespace

TEST(CsvFile, TouchesNothingBeforeTheFirstRow)
{
  test::TemporaryDirectory directory;
  test::write(directory / "a.csv", "earlier");
  CsvFile file(directory / "a.csv", "a,b", world());
  EXPECT_EQ(test::contents(directory / "a.csv"), "earlier");
  world()->barrier();
  file.flush();
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n");
}

TEST(CsvFile, RestartCutsBackToTheCheckpoint)
{
  test::TemporaryDirectory directory;
  const Archive archive = killedAfterCheckpoint(directory / "a.csv");
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n1,2\n3,4\n5,6\n");
  CsvFile file(directory / "a.csv", "a,b", world());
  world()->barrier();
  file.restore(archive);
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n1,2\n3,4\n");
  world()->barrier();
  file.writeRow("7,8");
  file.flush();
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n1,2\n3,4\n7,8\n");
}

TEST(CsvFile, RestartRefusesAnotherTable)
{
  test::TemporaryDirectory directory;
  const Archive archive = killedAfterCheckpoint(directory / "a.csv");
  CsvFile other(directory / "a.csv", "a,c", world());
  EXPECT_TRUE(
    test::contains(test::inputError([&] { other.restore(archive); }), "is not the table"));
  test::onRankZero([&] { std::filesystem::resize_file(directory / "a.csv", 8); });
  CsvFile shorter(directory / "a.csv", "a,b", world());
  EXPECT_TRUE(test::contains(test::inputError([&] { shorter.restore(archive); }), "has 8 bytes"));
  CsvFile missing(directory / "b.csv", "a,b", world());
  EXPECT_TRUE(test::contains(test::inputError([&] { missing.restore(archive); }),
                             "cannot be continued"));
}

TEST(CsvFile, FolderThatDoesNotExistIsRefusedOnEveryRank)
{
  test::TemporaryDirectory directory;
  CsvFile file(directory / "none/a.csv", "a", world());
  EXPECT_TRUE(test::contains(test::inputError([&] { file.flush(); }), "cannot be written"));
}

TEST(CsvFile, Numbers)
{
  const double third = 1e9 / 3;
  EXPECT_EQ(std::stod(io::exactNumber(third)), third);
  EXPECT_EQ(io::shortNumber(third), "3.3333333e+08");
  EXPECT_EQ(io::shortNumber(12), "12");
  EXPECT_EQ(io::shortNumber(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(io::columnName("slip", "m"), "slip [m]");
  EXPECT_EQ(io::columnName("iterations", "-"), "iterations");
}
