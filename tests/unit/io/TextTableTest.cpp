#include "io/files/TextTable.hpp"
#include "unit/io/Support.hpp"

#include <limits>

using namespace asperity;
using io::Archive;
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
  test::expectRefusal([&] { other.restore(archive); }, {"is not the table"});
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
  TextTable file(directory / "seas/a.txt", "a", world());
  file.flush();
  EXPECT_EQ(test::contents(directory / "seas/a.txt"), "a\n");
}

TEST(TextTable, AHeaderOfSeveralLinesMayChange)
{
  test::TemporaryDirectory directory;
  TextTable file(directory / "a.txt", "# steps=0\na b", world());
  file.writeRow("1 2");
  file.setHeader("# steps=1\na b");
  file.flush();
  file.writeRow("3 4");
  file.flush();
  EXPECT_EQ(test::contents(directory / "a.txt"), "# steps=1\na b\n1 2\n3 4\n");
}

TEST(TextTable, RestartTakesTheColumnsFromTheLastLineOfTheHeader)
{
  test::TemporaryDirectory directory;
  Archive archive;
  {
    TextTable file(directory / "a.txt", "# steps=0\na b", world());
    file.writeRow("1 2");
    file.flush();
    file.save(archive);
    file.setHeader("# steps=7\na b");
    file.writeRow("3 4");
    file.flush();
  }
  TextTable other(directory / "a.txt", "# steps=0\na c", world());
  test::expectRefusal([&] { other.restore(archive); }, {"is not the table"});
  TextTable file(directory / "a.txt", "# steps=0\na b", world());
  file.restore(archive);
  file.writeRow("5 6");
  file.setHeader("# steps=2\na b");
  file.flush();
  EXPECT_EQ(test::contents(directory / "a.txt"), "# steps=2\na b\n1 2\n5 6\n");
}

TEST(TextTable, RestartNamesTheLineOfTheHeaderThatHasAnotherLength)
{
  test::TemporaryDirectory directory;
  Archive archive;
  {
    TextTable file(directory / "a.txt", "# author=A\n# date=2024/05/31\na b", world());
    file.writeRow("1 2");
    file.flush();
    file.save(archive);
  }
  world()->barrier();
  TextTable longer(directory / "a.txt", "# author=A. B.\n# date=2024/05/31\na b", world());
  test::expectRefusal([&] { longer.restore(archive); },
                      {"the line '# author=A', where that of this run has "
                       "'# author=A. B.'"});
  TextTable more(directory / "a.txt", "# author=A\n# date=2024/05/31\na b c", world());
  test::expectRefusal([&] { more.restore(archive); },
                      {"the line 'a b', where that of this run has 'a b c'"});
  TextTable next_day(directory / "a.txt", "# author=A\n# date=2024/06/01\na b", world());
  next_day.restore(archive);
  next_day.flush();
  EXPECT_EQ(test::contents(directory / "a.txt"), "# author=A\n# date=2024/06/01\na b\n1 2\n");
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
