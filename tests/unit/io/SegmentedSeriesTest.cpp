#include "io/series/SegmentedSeries.hpp"
#include "unit/io/Support.hpp"

using namespace asperity;
using namespace asperity::io;
using test::world;

namespace
{
constexpr int num_base = 6;
namespace fs = std::filesystem;

// Row r of the fields: alpha = r + node / 16, slip = (r, -node), exact in single precision.
class Series
{
public:
  explicit Series(fs::path const& directory, bool single_precision = false)
      : domain(boundaryDomain("fault", test::stripMesh(num_base), "base", world()))
      , alpha{"alpha",
              "-",
              "State.",
              "fault",
              1,
              [this](std::vector<double>& values) {
                values.clear();
                for (const GlobalOrdinal node : domain.node_numbers) {
                  values.push_back(row + static_cast<double>(node) / 16);
                }
              }}
      , slip{"slip",
             "m",
             "Slip in two directions.",
             "fault",
             2,
             [this](std::vector<double>& values) {
               values.clear();
               for (const GlobalOrdinal node : domain.node_numbers) {
                 values.push_back(row);
                 values.push_back(-static_cast<double>(node));
               }
             }}
      , series({directory, "fault", single_precision, 4}, domain, {&alpha, &slip})
  {
  }

  // Rows from next_row on, of step 10 r at time r / 8.
  void append(int number)
  {
    for (int i = 0; i < number; ++i) {
      row = next_row++;
      series.append({10 * row, row / 8.0, 1 / 8.0, 0, false});
    }
  }

  int row = 0, next_row = 0;
  OutputDomain domain;
  OutputField alpha, slip;
  SegmentedSeries series;
};

// All rows 0, ..., rows - 1 are in the index and are those of Series.
void expectRows(fs::path const& directory, std::size_t rows)
{
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "fault.h5");
    const auto alpha = file.openDataset("fields/alpha");
    const auto slip = file.openDataset("fields/slip");
    ASSERT_EQ(alpha.shape(), (h5::Shape{rows, num_base}));
    ASSERT_EQ(slip.shape(), (h5::Shape{rows, num_base, 2}));
    const auto alphas = alpha.read<double>(), slips = slip.read<double>();
    const auto times = file.openDataset("time").read<double>();
    const auto steps = file.openDataset("step").read<std::int64_t>();
    for (std::size_t row = 0; row < rows; ++row) {
      const auto number = static_cast<double>(row);
      EXPECT_EQ(times[row], number / 8);
      EXPECT_EQ(steps[row], std::int64_t(10 * row));
      for (int node = 0; node < num_base; ++node) {
        EXPECT_EQ(alphas[row * num_base + node], number + node / 16.0);
        EXPECT_EQ(slips[2 * (row * num_base + node)], number);
        EXPECT_EQ(slips[2 * (row * num_base + node) + 1], -node);
      }
    }
  });
}

std::size_t countOf(std::string const& text, std::string const& part)
{
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}
} // namespace

TEST(SegmentedSeries, TheIndexIsOneContinuousArray)
{
  test::TemporaryDirectory directory;
  Series run(directory.path());
  run.append(9); // two writes of four rows and one of one
  run.series.closeSegment(0);
  expectRows(directory.path(), 9);
  run.series.closeSegment(1); // nothing in it
  run.append(2);
  run.series.closeSegment(2);
  expectRows(directory.path(), 11);
  EXPECT_FALSE(fs::exists(directory / "segments/fault_000001.h5"));
}

TEST(SegmentedSeries, GeometryAndAttributes)
{
  test::TemporaryDirectory directory;
  Series run(directory.path(), true);
  run.series.closeSegment(0);
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "fault.h5");
    EXPECT_EQ(file.textAttribute("format"), "asperity series");
    EXPECT_EQ(file.integerAttribute("format_version"), 1);
    EXPECT_EQ(file.textAttribute("location"), "fault");
    EXPECT_EQ(file.openDataset("fields/slip").textAttribute("unit"), "m");
    EXPECT_EQ(file.openDataset("fields/slip").textAttribute("description"),
              "Slip in two directions.");
    EXPECT_EQ(file.openDataset("fields/alpha").type(), h5::Type::float32);
    EXPECT_EQ(file.openDataset("fields/alpha").shape(), (h5::Shape{0, num_base}));
    EXPECT_EQ(file.openDataset("geometry/coordinates").shape(), (h5::Shape{num_base, 2}));
    EXPECT_EQ(file.openDataset("geometry/connectivity").shape(), (h5::Shape{num_base - 1, 2}));
    EXPECT_EQ(file.openDataset("geometry/weights").textAttribute("unit"), "m");
    EXPECT_EQ(file.openDataset("geometry/vertex_ids").read<std::int64_t>()[0], num_base - 1);
    EXPECT_EQ(file.openDataset("geometry/positions").textAttribute("description"),
              "Distance along the fault from its upper end (greater y; of ends equally high the "
              "one with smaller x).");
    const auto positions = file.openDataset("geometry/positions").read<double>();
    for (int i = 0; i < num_base; ++i) {
      EXPECT_NEAR(positions[i], test::stripPosition(i, num_base), 1e-15);
    }
  });
}

TEST(SegmentedSeries, AKilledRunIsRestartedFromItsCheckpoint)
{
  test::TemporaryDirectory directory;
  Archive archive;
  {
    Series run(directory.path());
    run.append(5);
    run.series.closeSegment(0);
    run.append(3);
    run.series.closeSegment(1);
    run.series.save(archive);
    run.append(7); // the checkpoint after this segment was never written
    run.series.closeSegment(2);
    run.append(6);
  }
  test::write(directory / "segments/fault_000003.h5", "torn: the process was killed in here");
  test::write(directory / "segments/surface_000003.h5", "of another series");
  Series run(directory.path());
  run.series.restore(archive);
  EXPECT_FALSE(fs::exists(directory / "segments/fault_000002.h5"));
  EXPECT_FALSE(fs::exists(directory / "segments/fault_000003.h5"));
  EXPECT_TRUE(fs::exists(directory / "segments/surface_000003.h5"));
  expectRows(directory.path(), 8);
  run.next_row = 8;
  run.append(4);
  run.series.closeSegment(2);
  expectRows(directory.path(), 12);
}

TEST(SegmentedSeries, ClosedSegmentsStayReadableWhileTheRunGoesOn)
{
  test::TemporaryDirectory directory;
  Series run(directory.path());
  run.append(5);
  run.series.closeSegment(0);
  run.append(13);
  expectRows(directory.path(), 5);
}

TEST(SegmentedSeries, ARestartWithoutItsSegmentsIsRefused)
{
  test::TemporaryDirectory directory, other;
  Archive archive;
  Series run(directory.path());
  run.append(2);
  run.series.closeSegment(0);
  run.series.save(archive);
  Series elsewhere(other.path());
  test::expectRefusal([&] { elsewhere.series.restore(archive); }, {"fault_000000.h5 is missing"});
}

TEST(SegmentedSeries, XdmfPointsIntoTheSegments)
{
  test::TemporaryDirectory directory;
  Series run(directory.path(), true);
  run.append(2);
  run.series.closeSegment(0);
  run.append(1);
  run.series.closeSegment(1);
  const std::string text = test::contents(directory / "fault.xdmf");
  EXPECT_EQ(countOf(text, "<Time Value="), 3u);
  EXPECT_EQ(countOf(text, "Name=\"alpha\" AttributeType=\"Scalar\""), 3u);
  EXPECT_EQ(countOf(text, "Name=\"slip\" AttributeType=\"Vector\""), 3u);
  EXPECT_EQ(countOf(text, "segments/fault_000001_rows.h5:/alpha/"), 1u);
  test::expectParts(text,
                    {"<Time Value=\"0.125\"/>",
                     "Precision=\"4\" Dimensions=\"6\">segments/fault_000000_rows.h5:/alpha/1<",
                     "Dimensions=\"6 3\">segments/fault_000000_rows.h5:/slip/0<",
                     "NodesPerElement=\"2\" NumberOfElements=\"5\""});
}

TEST(SegmentedSeries, WithoutRowsThereIsNoXdmf)
{
  test::TemporaryDirectory directory;
  Series run(directory.path());
  run.series.closeSegment(0);
  EXPECT_FALSE(fs::exists(directory / "fault.xdmf"));
  run.append(1);
  run.series.closeSegment(1);
  EXPECT_TRUE(fs::exists(directory / "fault.xdmf"));
}

TEST(SegmentedSeries, ARestartMakesTheXdmfOfWhatItContinues)
{
  test::TemporaryDirectory directory;
  Archive archive;
  {
    Series run(directory.path());
    run.append(2);
    run.series.closeSegment(0);
    run.series.save(archive);
    run.append(3); // the checkpoint after this segment was never written
    run.series.closeSegment(1);
  }
  test::onRankZero([&] { fs::remove(directory / "segments/fault_000000_rows.h5"); });
  Series run(directory.path());
  run.series.restore(archive);
  EXPECT_EQ(countOf(test::contents(directory / "fault.xdmf"), "<Time Value="), 2u);
  EXPECT_TRUE(fs::exists(directory / "segments/fault_000000_rows.h5"));
  EXPECT_FALSE(fs::exists(directory / "segments/fault_000001_rows.h5"));
}

TEST(SegmentedSeries, H5pyReadsTheFolderWhereverItIs)
{
  const std::string python = ASPERITY_PYTHON;
  if (python.empty()) {
    GTEST_SKIP() << "no Python with h5py";
  }
  test::TemporaryDirectory directory;
  test::onRankZero([&] { fs::create_directory(directory / "first"); });
  Series run(directory / "first");
  run.append(6);
  run.series.closeSegment(0);
  run.append(5);
  run.series.closeSegment(1);
  test::onRankZero([&] {
    fs::rename(directory / "first", directory / "moved");
    const std::string command = "cd / && " + python + " " + ASPERITY_TEST_SOURCES +
                                "/read_series.py " + (directory / "moved/fault.h5").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
  });
}
