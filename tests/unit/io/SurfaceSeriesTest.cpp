#include "io/series/SegmentedSeries.hpp"
#include "unit/io/BlockMesh.hpp"
#include "unit/io/Stage.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <array>

using namespace asperity;
using namespace asperity::io;
using test::world;

namespace
{
// Fields linear in place and time: T = t + x + 10 y + 100 z, u_c = (c + 1) T.
struct Block : test::Stage
{
  explicit Block(bool periodic) : Stage(test::blockMesh(periodic))
  {
    for (std::string const domain : {"fault", "volume"}) {
      add(domain, "T", 1, [this](double const* x, int) { return value(x); });
      add(domain, "u", 3, [this](double const* x, int c) { return (c + 1) * value(x); });
    }
  }

  double value(double const* x) const { return time + x[0] + 10 * x[1] + 100 * x[2]; }

  // Five rows in two segments, two rows a write.
  void write(std::filesystem::path const& directory, std::string const& domain)
  {
    SegmentedSeries series({directory, domain, false, 2}, domains.at(domain),
                           {&fields.field(domain, "T"), &fields.field(domain, "u")});
    for (int step = 0; step < 5; ++step) {
      series.append(at(step, 0.5));
      if (step == 2) {
        series.closeSegment(0);
      }
    }
    series.closeSegment(1);
  }
};

void expectFields(std::filesystem::path const& path)
{
  const auto file = h5::File::open(path);
  const auto x = file.openDataset("geometry/coordinates").read<double>();
  const auto scalar = file.openDataset("fields/T").read<double>();
  const auto vector = file.openDataset("fields/u");
  const std::size_t nodes = x.size() / 3;
  ASSERT_EQ(vector.shape(), (h5::Shape{5, nodes, 3}));
  const auto vectors = vector.read<double>();
  for (std::size_t row = 0; row < 5; ++row) {
    for (std::size_t node = 0; node < nodes; ++node) {
      const double expected =
        0.5 * static_cast<double>(row) + x[3 * node] + 10 * x[3 * node + 1] + 100 * x[3 * node + 2];
      ASSERT_EQ(scalar[row * nodes + node], expected);
      ASSERT_EQ(vectors[3 * (row * nodes + node) + 2], 3 * expected);
    }
  }
}
} // namespace

TEST(SurfaceSeries, EveryRankWritesItsPart)
{
  for (std::string const domain : {"fault", "volume"}) {
    test::TemporaryDirectory directory;
    Block(false).write(directory.path(), domain);
    test::onRankZero([&] { expectFields(directory / (domain + ".h5")); });
  }
}

TEST(SurfaceSeries, GeometryIsInTheOrderOfTheNodesOnAnyNumberOfRanks)
{
  test::TemporaryDirectory directory;
  Block(false).write(directory.path(), "volume");
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "volume.h5");
    const auto ids = file.openDataset("geometry/vertex_ids").read<std::int64_t>();
    EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
    const auto nodes = file.openDataset("geometry/connectivity").read<std::int64_t>();
    ASSERT_EQ(nodes.size(), std::size_t(4 * 6 * test::block_nx * test::block_nz));
    std::vector<std::array<std::int64_t, 4>> elements;
    for (std::size_t first = 0; first < nodes.size(); first += 4) {
      elements.push_back({nodes[first], nodes[first + 1], nodes[first + 2], nodes[first + 3]});
      std::sort(elements.back().begin(), elements.back().end());
    }
    EXPECT_TRUE(std::is_sorted(elements.begin(), elements.end()));
    EXPECT_EQ(std::adjacent_find(elements.begin(), elements.end()), elements.end());
    EXPECT_EQ(file.openDataset("geometry/weights").textAttribute("unit"), "m^3");
    EXPECT_FALSE(file.has("geometry/whole_elements"));
  });
}

TEST(SurfaceSeries, ElementsAcrossAPeriodAreNotDrawn)
{
  test::TemporaryDirectory directory;
  Block(true).write(directory.path(), "fault");
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "fault.h5");
    const hsize_t all = 2 * test::block_nx * test::block_nz, across = 2 * test::block_nx;
    EXPECT_EQ(file.openDataset("geometry/connectivity").shape(), (h5::Shape{all, 3}));
    EXPECT_EQ(file.openDataset("geometry/whole_elements").shape(), (h5::Shape{all - across, 3}));
    const auto text = test::contents(directory / "fault.xdmf");
    test::expectParts(text, {"TopologyType=\"Triangle\" NumberOfElements=\"16\"",
                             "fault_geometry.h5:/geometry/whole_elements"});
  });
}

TEST(SurfaceSeries, ASegmentThatCannotBeWrittenIsAnErrorOnEveryRank)
{
  test::TemporaryDirectory directory;
  Block block(false);
  SegmentedSeries series({directory.path(), "fault", false, 1}, block.domains.at("fault"),
                         {&block.fields.field("fault", "T")});
  series.append(block.at(0, 0.5));
  test::onRankZero([&] { std::filesystem::remove_all(directory / "segments"); });
  EXPECT_THROW(series.append(block.at(1, 0.5)), OutputError);
}

TEST(SurfaceSeries, VtkReadsTheXdmf)
{
  const std::string python = ASPERITY_PYTHON;
  if (python.empty()) {
    GTEST_SKIP() << "no Python with h5py";
  }
  test::TemporaryDirectory directory;
  Block(false).write(directory.path(), "fault");
  Block(false).write(directory.path(), "volume");
  test::onRankZero([&] { std::filesystem::create_directory(directory / "periodic"); });
  Block(true).write(directory / "periodic", "volume");
  int status = 0;
  test::onRankZero([&] {
    const std::string command =
      python + " " + ASPERITY_TEST_SOURCES + "/read_xdmf.py " + directory.path().string();
    status = std::system(command.c_str());
  });
  Teuchos::broadcast(*world(), 0, Teuchos::outArg(status));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 77) {
    GTEST_SKIP() << "no VTK that reads XDMF";
  }
  EXPECT_EQ(status, 0);
}
