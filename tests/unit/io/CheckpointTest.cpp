#include "io/checkpoint/Checkpoint.hpp"
#include "hdf5/File.hpp"
#include "io/checkpoint/SharedArchive.hpp"
#include "unit/io/Support.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace asperity;
using test::world;

namespace
{
// Another one on every rank, with values that are easily lost.
Archive stateOfRank()
{
  const int rank = world()->getRank();
  Archive archive;
  archive.set("step", (std::int64_t(1) << 53) + 1 + rank);
  archive.set("time", std::nextafter(0.1, 1.0) + rank);
  archive.set("name", std::string("rank\0", 5) + std::to_string(rank));
  archive.set("state/velocity", std::vector<double>(10 * rank + 1, 5e-324));
  archive.set("state/alpha", std::vector<double>{-0.0, 1e308, -1.0 / 3});
  archive.set("state/none", std::vector<double>{});
  archive.set("outputs/Event Catalogue/ruptured", std::vector<std::int64_t>{0, 1, -1});
  if (rank == 0) {
    archive.set("outputs/table", std::string("only here"));
  } else {
    archive.set("ranks/others", rank);
  }
  return archive;
}

io::Fingerprint deck(std::string const& friction = "0.01", std::string const& checksum = "a1",
                     std::string const& file = "body.h5")
{
  return {{{"Asperity / Friction / a", friction, ""},
           {"Asperity / Mesh / File / File Name", checksum, "mesh file '" + file + "'"}}};
}

class Checkpoint : public ::testing::Test
{
protected:
  void SetUp() override { io::writeCheckpoint(file, stateOfRank(), deck(), *world()); }

  std::string errorOfReading(io::Fingerprint const& fingerprint = deck())
  {
    return test::refusal([&] { io::readCheckpoint(file, fingerprint, *world()); });
  }

  test::TemporaryDirectory directory;
  std::filesystem::path file = directory / "checkpoint.h5";
};
} // namespace

TEST_F(Checkpoint, ReadsBackBitForBit)
{
  const Archive copy = io::readCheckpoint(file, deck(), *world());
  EXPECT_EQ(Archive(copy).values(), stateOfRank().values());
  EXPECT_TRUE(std::signbit(copy.get<std::vector<double>>("state/alpha")[0]));
}

// Every value has one dataset, whatever the number of ranks.
TEST_F(Checkpoint, HasTheValuesOfOneRankAfterTheOther)
{
  const auto num_ranks = static_cast<std::size_t>(world()->getSize());
  test::onRankZero([&] {
    const auto h5 = h5::File::open(file);
    EXPECT_EQ(h5.openDataset("values/state/alpha").shape(), h5::Shape{3 * num_ranks});
    EXPECT_EQ(h5.openDataset("values/state/velocity").shape(),
              h5::Shape{num_ranks + 10 * num_ranks * (num_ranks - 1) / 2});
    const auto steps = h5.openDataset("values/step").read<std::int64_t>();
    EXPECT_EQ(steps.back() - steps.front(), static_cast<std::int64_t>(num_ranks) - 1);
  });
}

// Sizes that do not fit the datasets are refused before any rank reads, and none waits.
TEST_F(Checkpoint, SizesThatDoNotFitAreRefused)
{
  test::onRankZero([&] {
    auto h5 = h5::File::openShared(file, MPI_COMM_SELF);
    const auto entries = h5.openDataset("entries").readTexts();
    auto sizes = h5.openDataset("sizes").read<std::int64_t>();
    const auto alpha = std::find(entries.begin(), entries.end(), "state/alpha") - entries.begin();
    ASSERT_EQ(sizes.at(alpha), 3);
    sizes[alpha] = 4;
    h5.openDataset("sizes").writePart(sizes.data(), {0, 1});
    h5.close();
  });
  const auto message = errorOfReading();
  test::expectParts(message, {"values/state/alpha has another shape"});
}

// Values of many gigabytes go in rounds; here of a few numbers, and ranks have differently many.
TEST_F(Checkpoint, LargeValuesGoInRounds)
{
  const Archive archive = stateOfRank();
  const io::detail::ArchiveLayout layout(archive, *world());
  const auto path = directory / "rounds.h5";
  test::onRankZero([&] {
    auto h5 = h5::File::create(path);
    layout.create(h5, world()->getSize());
  });
  auto h5 = h5::File::openShared(path, rawCommunicator(*world()));
  layout.write(h5, archive, *world(), 2);
  const auto together = [](std::function<void()> const& work) { work(); };
  h5.close();
  const auto reading = h5::File::openSharedForReading(path, rawCommunicator(*world()));
  const auto entries = io::detail::readEntries(reading);
  const auto sizes = io::detail::readSizes(reading, entries, world()->getSize());
  const io::detail::ArchiveLayout mine(
    entries, sizes, std::size_t(world()->getRank()), [](auto const&) { return true; }, *world());
  EXPECT_EQ(mine.read(reading, together, 7).values(), archive.values());
}

TEST_F(Checkpoint, IsReplacedAndLeavesNoTemporaryFile)
{
  Archive later = stateOfRank();
  later.set("time", 7.0);
  io::writeCheckpoint(file, later, deck(), *world());
  EXPECT_EQ(io::readCheckpoint(file, deck(), *world()).getDouble("time"), 7.0);
  const auto files = std::filesystem::directory_iterator(directory.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST_F(Checkpoint, SurvivesAKilledWrite)
{
  test::write(directory / "checkpoint.h5.part", "half a file");
  EXPECT_EQ(io::readCheckpoint(file, deck(), *world()).values(), stateOfRank().values());
  io::writeCheckpoint(file, stateOfRank(), deck(), *world());
  EXPECT_FALSE(std::filesystem::exists(directory / "checkpoint.h5.part"));
}

TEST_F(Checkpoint, MissingFileIsRefused)
{
  file = directory / "none.h5";
  test::expectParts(errorOfReading(), {"There is no checkpoint"});
}

TEST_F(Checkpoint, OtherDeckIsRefusedWithWhatDiffersFirst)
{
  const auto message = errorOfReading(deck("0.02", "b2"));
  test::expectParts(
    message, {"belongs to another deck", "Asperity / Friction / a is '0.02', and was '0.01'."});
  auto longer = deck();
  longer.entries.push_back({"Asperity / Friction / b", "1", ""});
  test::expectParts(errorOfReading(longer), {"Asperity / Friction / b is new."});
  test::expectParts(errorOfReading({}), {"Friction / a is missing, and was '0.01'."});
}

TEST_F(Checkpoint, OtherContentOfAFileIsRefusedAndACopyIsNot)
{
  test::expectParts(errorOfReading(deck("0.01", "b2")),
                    {"the content of mesh file 'body.h5' (Asperity / Mesh / File / File "
                     "Name) has changed since then."});
  EXPECT_EQ(io::readCheckpoint(file, deck("0.01", "a1", "copy.h5"), *world()).values(),
            stateOfRank().values());
}

TEST_F(Checkpoint, TruncatedFileIsRefused)
{
  test::onRankZero([&] { std::filesystem::resize_file(file, 3000); });
  test::expectParts(errorOfReading(), {"damaged"});
}

TEST_F(Checkpoint, SomethingElseIsRefused)
{
  test::write(file, "no HDF5 at all");
  test::expectParts(errorOfReading(), {"not a checkpoint of Asperity"});
  test::onRankZero([&] {
    h5::File::create(file, h5::Layout::sealed)
      .setAttribute("format", std::string("x"), h5::TextLength::fixed);
  });
  test::expectParts(errorOfReading(), {"is not a checkpoint of Asperity"});
}

// In HDF5's old format a changed byte can crash HDF5.
TEST_F(Checkpoint, AFileWithoutChecksumsOfHdf5IsNotOpened)
{
  test::onRankZero([&] { h5::File::create(file).setAttribute("format", std::string("x")); });
  test::expectParts(errorOfReading(), {"does not begin as one"});
}

TEST_F(Checkpoint, AChangedValueIsNoticed)
{
  test::onRankZero([&] {
    std::string bytes = test::contents(file);
    const double written = 1e308;
    const auto place = bytes.find(std::string(reinterpret_cast<char const*>(&written), 8));
    ASSERT_NE(place, std::string::npos);
    bytes[place] ^= 1;
    std::ofstream(file, std::ios::binary) << bytes;
  });
  test::expectParts(errorOfReading(), {"is damaged: the values of rank 0 differ"});
}

TEST_F(Checkpoint, OtherVersionIsRefused)
{
  test::onRankZero([&] {
    auto h5 = h5::File::create(file, h5::Layout::sealed);
    h5.setAttribute("format", std::string("asperity checkpoint"), h5::TextLength::fixed);
    h5.setAttribute("format_version", std::int64_t(99));
  });
  test::expectParts(errorOfReading(), {"has format version 99, but this version reads 10"});
}

namespace
{
// Of 10 nodes a rank has those for which number % parts == rank, from the last one down if asked.
NodeSets nodesOfRank(int parts, bool is_reversed = false)
{
  NodeSets sets{{"body", {}}, {"none", {}}};
  for (int node = 0; node < 10; ++node) {
    if (node % parts == world()->getRank()) {
      sets["body"].push_back(node);
    }
  }
  if (is_reversed) {
    std::reverse(sets["body"].begin(), sets["body"].end());
  }
  return sets;
}

Archive atNodes(NodeSets const& sets)
{
  std::vector<double> values;
  std::vector<std::int64_t> marks;
  for (const auto node : sets.at("body")) {
    const auto number = static_cast<double>(node);
    values.insert(values.end(), {0.1 * number, -1e-300 * number});
    marks.push_back((std::int64_t(1) << 60) + node);
  }
  Archive archive;
  archive.set("time", 7.0);
  archive.setAtNodes("state/u", values, "body");
  archive.setAtNodes("ruptured", marks, "body");
  archive.setAtNodes("not yet", std::vector<double>{}, "body");
  return archive;
}
} // namespace

// Other ranks have the nodes, and in another order.
TEST_F(Checkpoint, ValuesAtNodesGoWhereTheNodesAre)
{
  for (const int parts : {1, world()->getSize()}) {
    const auto there = nodesOfRank(parts), here = nodesOfRank(world()->getSize(), true);
    io::writeCheckpoint(file, atNodes(there), deck(), *world(), there);
    const auto read = io::readCheckpoint(file, deck(), *world(), here);
    const auto expected = atNodes(here);
    for (auto const& [path, value] : expected.values()) {
      EXPECT_EQ(read.values().at(path), value) << path;
    }
  }
}

TEST_F(Checkpoint, AFileOfOneRankIsReadByAll)
{
  const auto all = nodesOfRank(1);
  test::onRankZero([&] {
    const Teuchos::MpiComm<int> alone(MPI_COMM_SELF);
    io::writeCheckpoint(file, atNodes(all), deck(), alone, all);
  });
  const auto here = nodesOfRank(world()->getSize());
  const auto read = io::readCheckpoint(file, deck(), *world(), here);
  const auto expected = atNodes(here);
  for (auto const& [path, value] : expected.values()) {
    EXPECT_EQ(read.values().at(path), value) << path;
  }
}

TEST_F(Checkpoint, OtherNodesAreRefused)
{
  const auto there = nodesOfRank(world()->getSize());
  io::writeCheckpoint(file, atNodes(there), deck(), *world(), there);
  auto here = there;
  here["body"].front() += 100;
  test::expectRefusal([&] { io::readCheckpoint(file, deck(), *world(), here); }, {"another mesh"});
}

TEST_F(Checkpoint, FolderThatDoesNotExistIsAnErrorOnEveryRank)
{
  EXPECT_THROW(io::writeCheckpoint(directory / "none/checkpoint.h5", stateOfRank(), {}, *world()),
               OutputError);
}
