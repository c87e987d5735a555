#include "io/checkpoint/Checkpoint.hpp"
#include "hdf5/File.hpp"
#include "unit/io/Support.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

using namespace asperity;
using test::world;

namespace
{
// With values that are easily lost. What is not at nodes comes from rank 0.
Archive stateOfRun()
{
  Archive archive;
  archive.set("step", (std::int64_t(1) << 53) + 1);
  archive.set("time", std::nextafter(0.1, 1.0));
  archive.set("name", std::string("run\0x", 5));
  archive.set("state/velocity", std::vector<double>(11, 5e-324));
  archive.set("state/alpha", std::vector<double>{-0.0, 1e308, -1.0 / 3});
  archive.set("state/none", std::vector<double>{});
  archive.set("outputs/Event Catalogue/ruptured", std::vector<std::int64_t>{0, 1, -1});
  return archive;
}

Archive stateOfRank()
{
  if (world()->getRank() == 0) {
    return stateOfRun();
  }
  Archive archive;
  archive.set("step", 3);
  archive.set("state/velocity", std::vector<double>{1});
  archive.set("ranks/others", world()->getRank());
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

// Every rank gets what rank 0 had.
TEST_F(Checkpoint, ReadsBackBitForBit)
{
  const Archive copy = io::readCheckpoint(file, deck(), *world());
  EXPECT_EQ(copy.values(), stateOfRun().values());
  EXPECT_TRUE(std::signbit(copy.get<std::vector<double>>("state/alpha")[0]));
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
  EXPECT_EQ(io::readCheckpoint(file, deck(), *world()).values(), stateOfRun().values());
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
            stateOfRun().values());
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
  test::expectParts(errorOfReading(),
                    {"is damaged", "The values of 'state/alpha' differ from what was written."});
}

TEST_F(Checkpoint, OtherVersionsAreRefused)
{
  for (const int version : {0, 2}) {
    test::onRankZero([&] {
      auto h5 = h5::File::create(file, h5::Layout::sealed);
      h5.setAttribute("format", std::string("asperity checkpoint"), h5::TextLength::fixed);
      h5.setAttribute("format_version", std::int64_t(version));
    });
    test::expectParts(errorOfReading(),
                      {"has format version " + std::to_string(version), "but this version reads 1.",
                       "the version of Asperity that wrote it"});
  }
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

// Numbers need not be without gaps, and ranks may have their nodes in any order.
TEST_F(Checkpoint, ValuesAtNodesAreInTheOrderOfTheirNumbers)
{
  auto sets = nodesOfRank(world()->getSize(), true);
  auto const archive = atNodes(sets);
  for (auto& node : sets["body"]) {
    node = 7 * node + 3;
  }
  io::writeCheckpoint(file, archive, deck(), *world(), sets);
  test::onRankZero([&] {
    const auto h5 = h5::File::open(file);
    const auto marks = h5.openDataset("values/ruptured").read<std::int64_t>();
    std::vector<std::int64_t> expected;
    for (int node = 0; node < 10; ++node) {
      expected.push_back((std::int64_t(1) << 60) + node);
    }
    EXPECT_EQ(marks, expected);
    EXPECT_EQ(h5.openDataset("values/state/u").shape(), h5::Shape{20});
    EXPECT_EQ(h5.openDataset("values/not yet").shape(), h5::Shape{0});
    EXPECT_EQ(h5.openDataset("set_sizes").read<std::int64_t>(), std::vector<std::int64_t>{10});
  });
}

// The file does not show which ranks wrote it.
TEST_F(Checkpoint, HasTheSameValuesOnAnyRanks)
{
  const auto all = nodesOfRank(1), here = nodesOfRank(world()->getSize(), true);
  const auto values = [&] {
    const auto h5 = h5::File::open(file);
    std::vector<std::vector<std::int64_t>> lists;
    for (auto const* name : {"checksums", "set_checksums", "values/ruptured"}) {
      lists.push_back(h5.openDataset(name).read<std::int64_t>());
    }
    return std::pair(lists, h5.openDataset("values/state/u").read<double>());
  };
  io::writeCheckpoint(file, atNodes(all), deck(), *world(), all);
  std::pair<std::vector<std::vector<std::int64_t>>, std::vector<double>> alone;
  test::onRankZero([&] { alone = values(); });
  io::writeCheckpoint(file, atNodes(here), deck(), *world(), here);
  test::onRankZero([&] { EXPECT_EQ(values(), alone); });
}

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

// Values that do not fit their nodes are an error of the program, and no rank waits.
TEST_F(Checkpoint, ValuesThatDoNotFitTheirNodesAreRefused)
{
  const auto sets = nodesOfRank(world()->getSize());
  auto archive = atNodes(sets);
  if (world()->getRank() == 0) {
    archive.setAtNodes("not yet", std::vector<double>{1}, "body");
  }
  EXPECT_THROW(io::writeCheckpoint(file, archive, deck(), *world(), sets), std::exception);
  if (world()->getSize() > 1) {
    archive = world()->getRank() == 0 ? Archive() : atNodes(sets);
    EXPECT_THROW(io::writeCheckpoint(file, archive, deck(), *world(), sets), std::exception);
  }
}

// What a value of nodes says about its shape must fit the set.
TEST_F(Checkpoint, ASizeThatDoesNotFitTheNodesIsRefused)
{
  const auto sets = nodesOfRank(world()->getSize());
  io::writeCheckpoint(file, atNodes(sets), deck(), *world(), sets);
  test::onRankZero([&] {
    auto h5 = h5::File::openForWriting(file);
    auto kinds = h5.openDataset("kinds").read<std::int64_t>();
    const auto entries = h5.openDataset("entries").readTexts();
    const auto time = std::find(entries.begin(), entries.end(), "time") - entries.begin();
    kinds[time] = 3;                                                                   // a list
    kinds[std::find(entries.begin(), entries.end(), "state/u") - entries.begin()] = 1; // a number
    h5.openDataset("kinds").writePart(kinds.data(), {0, kinds.size()});
    h5.close();
  });
  const auto message = test::refusal([&] { io::readCheckpoint(file, deck(), *world(), sets); });
  test::expectParts(message, {"state/u", "cannot belong to nodes"});
}

TEST_F(Checkpoint, FolderThatDoesNotExistIsAnErrorOnEveryRank)
{
  EXPECT_THROW(io::writeCheckpoint(directory / "none/checkpoint.h5", stateOfRank(), {}, *world()),
               OutputError);
}
