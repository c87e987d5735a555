#include "base/parallel/Messages.hpp"
#include "hdf5/File.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultComm.hpp>
#include <gtest/gtest.h>

#include <unistd.h>

using namespace asperity;

namespace
{
// A file that all ranks use together.
class SharedH5 : public ::testing::Test
{
protected:
  SharedH5()
  {
    int process = ::getpid();
    Teuchos::broadcast(*world, 0, &process);
    path = std::filesystem::temp_directory_path() / ("asperity_" + std::to_string(process) + ".h5");
  }
  ~SharedH5() override
  {
    world->barrier();
    if (rank == 0) {
      std::filesystem::remove(path);
    }
    world->barrier();
  }

  h5::File openShared() const { return h5::File::openShared(path, rawCommunicator(*world)); }

  RCP<const Communicator> world = Teuchos::DefaultComm<int>::getComm();
  hsize_t rank = static_cast<hsize_t>(world->getRank());
  hsize_t num_ranks = static_cast<hsize_t>(world->getSize());
  std::filesystem::path path;
};
} // namespace

// Rank r has r rows of two numbers: the first has none and takes part all the same.
TEST_F(SharedH5, EachRankWritesAndReadsItsPart)
{
  const h5::Part mine{rank * (rank - (rank > 0 ? 1 : 0)) / 2, rank};
  const hsize_t all = num_ranks * (num_ranks - 1) / 2;
  if (rank == 0) {
    auto file = h5::File::create(path);
    file.create("rows", h5::Type::int64, {all, 2});
    file.close();
  }
  world->barrier();
  const std::vector<std::int64_t> rows(2 * rank, static_cast<std::int64_t>(rank));
  {
    auto file = openShared();
    file.openDataset("rows").writePart(rows.data(), mine);
    file.close();
  }
  {
    auto file = h5::File::openSharedForReading(path, rawCommunicator(*world));
    std::vector<std::int64_t> back(rows.size(), -1);
    file.openDataset("rows").readPart(back.data(), mine);
    EXPECT_EQ(back, rows);
    file.close();
  }
}

TEST_F(SharedH5, EachRankAppendsItsPartOfARow)
{
  if (rank == 0) {
    auto file = h5::File::create(path);
    file.createExtendable("history", h5::Type::float32, {num_ranks}, 4, true);
    file.close();
  }
  world->barrier();
  auto file = openShared();
  const double numbers[] = {1.0 + static_cast<double>(rank), 10.0};
  file.openDataset("history").appendPart(numbers, 2, {rank, 1});
  std::vector<double> row(num_ranks);
  file.openDataset("history").readAlone(row.data(), {0, 1});
  for (hsize_t r = 0; r < num_ranks; ++r) {
    EXPECT_EQ(row[r], 1.0 + static_cast<double>(r));
  }
  file.close();
}
