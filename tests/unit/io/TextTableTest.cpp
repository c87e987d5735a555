#include "io/files/TextTable.hpp"
#include "unit/io/Support.hpp"

#include <limits>

using namespace asperity;
using io::TextTable;
using test::world;

namespace
{
// Two rows, a checkpoint, a third row on disk, then the end without a word.
Archive killedAfterCheckpoint(std::filesystem::path const& path)
{
  TextTable file(path, "a,b", world());
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

TEST(TextTable, TouchesNothingBeforeTheFirstRow)
{
  test::TemporaryDirectory directory;
  test::write(directory / "a.csv", "earlier");
  TextTable file(directory / "a.csv", "a,b", world());
  EXPECT_EQ(test::contents(directory / "a.csv"), "earlier");
  world()->barrier();
  file.flush();
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n");
}

TEST(TextTable, RestartCutsBackToTheCheckpoint)
{
  test::TemporaryDirectory directory;
  const Archive archive = killedAfterCheckpoint(directory / "a.csv");
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n1,2\n3,4\n5,6\n");
  TextTable file(directory / "a.csv", "a,b", world());
  world()->barrier();
  file.restore(archive);
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n1,2\n3,4\n");
  world()->barrier();
  file.writeRow("7,8");
  file.flush();
  EXPECT_EQ(test::contents(directory / "a.csv"), "a,b\n1,2\n3,4\n7,8\n");
}

TEST(TextTable, RestartRefusesAnotherTable)
{
  test::TemporaryDirectory directory;
  const Archive archive = killedAfterCheckpoint(directory / "a.csv");
  TextTable other(directory / "a.csv", "a,c", world());
  test::expectRefusal([&] { other.restore(archive); },
                      {"its header is 'a,b', that of this run 'a,c'"});
  test::onRankZero([&] { std::filesystem::resize_file(directory / "a.csv", 8); });
  TextTable shorter(directory / "a.csv", "a,b", world());
  test::expectRefusal([&] { shorter.restore(archive); }, {"has 8 bytes"});
  TextTable missing(directory / "b.csv", "a,b", world());
  test::expectRefusal([&] { missing.restore(archive); }, {"cannot be continued"});
}

TEST(TextTable, RestartRefusesARowThatWasEditedAtEqualLength)
{
  test::TemporaryDirectory directory;
  const Archive archive = killedAfterCheckpoint(directory / "a.csv");
  world()->barrier();
  test::write(directory / "a.csv", "a,b\n1,2\n3,9\n5,6\n");
  TextTable edited(directory / "a.csv", "a,b", world());
  test::expectRefusal([&] { edited.restore(archive); }, {"a row"});
}

TEST(TextTable, FolderThatDoesNotExistIsAnErrorOnEveryRank)
{
  test::TemporaryDirectory directory;
  TextTable file(directory / "none/deeper/a.csv", "a", world());
  EXPECT_THROW(file.flush(), OutputError);
}

TEST(TextTable, MakesItsFolder)
{
  test::TemporaryDirectory directory;
  TextTable file(directory / "folder/a.txt", "a", world());
  file.flush();
  EXPECT_EQ(test::contents(directory / "folder/a.txt"), "a\n");
}

TEST(TextTable, Numbers)
{
  const double third = 1e9 / 3;
  EXPECT_EQ(std::stod(io::exactNumber(third)), third);
  EXPECT_EQ(io::shortNumber(third), "3.3333333e+08");
  EXPECT_EQ(io::shortNumber(12), "12");
  EXPECT_EQ(io::shortNumber(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(io::columnName("slip", "m"), "slip [m]");
  EXPECT_EQ(io::columnName("iterations", "-"), "iterations");
}
