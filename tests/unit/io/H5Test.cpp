#include "base/hdf5/H5.hpp"
#include "unit/io/Support.hpp"

#include <cmath>

using namespace asperity;

// HDF5 files belong to one rank here; every rank uses one of its own.
namespace
{
class H5 : public ::testing::Test
{
protected:
  std::filesystem::path path(std::string const& name = "file")
  {
    return directory / (name + std::to_string(test::world()->getRank()) + ".h5");
  }
  test::TemporaryDirectory directory;
};
} // namespace

TEST_F(H5, TextsReadBack)
{
  const std::vector<std::string> texts{"dp075", "",
                                       "Gr\xc3\xbc\xc3\x9f"
                                       "e"};
  {
    auto file = h5::File::create(path());
    file.createTexts("on_fault/names", texts);
    file.createTexts("none", {});
    file.close();
  }
  const auto file = h5::File::open(path());
  EXPECT_EQ(file.openDataset("on_fault/names").readTexts(), texts);
  EXPECT_TRUE(file.openDataset("none").readTexts().empty());
}

TEST_F(H5, ValuesAndAttributesReadBack)
{
  const std::vector<double> values{1, 1.0 / 3, -5};
  const std::int64_t large = (std::int64_t(1) << 60) + 1;
  {
    auto file = h5::File::create(path());
    file.setAttribute("name", std::string("Gr\xc3\xbc\xc3\x9f"
                                          "e"));
    file.setAttribute("version", std::int64_t(-3));
    file.create("a/b/real", h5::Type::float64, {3}).write(values.data());
    file.create("a/single", h5::Type::int64, {}).write(&large);
    file.create("a/none", h5::Type::float64, {0, 2}).write(values.data());
    file.close();
  }
  const auto file = h5::File::open(path());
  EXPECT_EQ(file.textAttribute("name"), "Gr\xc3\xbc\xc3\x9f"
                                        "e");
  EXPECT_EQ(file.integerAttribute("version"), -3);
  EXPECT_EQ(file.openDataset("a/b/real").readDoubles(), values);
  EXPECT_EQ(file.openDataset("a/single").readIntegers(), std::vector<std::int64_t>{large});
  EXPECT_TRUE(file.openDataset("a/single").shape().empty());
  EXPECT_EQ(file.openDataset("a/none").shape(), (h5::Shape{0, 2}));
  EXPECT_TRUE(file.openDataset("a/none").readDoubles().empty());
  EXPECT_TRUE(file.has("a/b/real"));
  EXPECT_FALSE(file.has("a/c/real"));
  EXPECT_EQ(file.openGroup("a").names(), (std::vector<std::string>{"b", "none", "single"}));
  EXPECT_TRUE(file.isGroup("a/b"));
  EXPECT_FALSE(file.isGroup("a/single"));
}

TEST_F(H5, RowsAreAppended)
{
  const std::vector<double> rows{1, 2, 3, 4, 5, 6};
  auto file = h5::File::create(path());
  auto dataset = file.createExtendable("v", h5::Type::float32, {2}, 4);
  dataset.append(rows.data(), 1);
  dataset.append(rows.data() + 2, 2);
  EXPECT_EQ(dataset.shape(), (h5::Shape{3, 2}));
  EXPECT_EQ(dataset.readDoubles(), rows);
  EXPECT_EQ(dataset.type(), h5::Type::float32);
}

TEST_F(H5, VirtualDatasetJoinsFilesAndSkipsEmptyParts)
{
  for (int part = 0; part < 2; ++part) {
    auto file = h5::File::create(path("part" + std::to_string(part) + "_"));
    const std::vector<double> rows{10.0 * part, 10.0 * part + 1};
    file.createExtendable("x/v", h5::Type::float64, {}, 8).append(rows.data(), part + 1);
  }
  auto index = h5::File::create(path("index"));
  const auto name = [&](int part) {
    return path("part" + std::to_string(part) + "_").filename().string();
  };
  auto joined =
    index.createVirtual("x/v", h5::Type::float64, {}, {{name(0), 1}, {"none.h5", 0}, {name(1), 2}});
  EXPECT_EQ(joined.shape(), h5::Shape{3});
  EXPECT_EQ(joined.readDoubles(), (std::vector<double>{0, 10, 11}));
  auto torn = index.createVirtual("torn/v", h5::Type::float32, {}, {{"none.h5", 2}});
  EXPECT_TRUE(std::isnan(torn.readDoubles()[1])); // HDF5 alone would say 0
  auto torn_steps = index.createVirtual("torn/n", h5::Type::int64, {}, {{"none.h5", 1}});
  EXPECT_EQ(torn_steps.readIntegers()[0], -1);
  EXPECT_EQ(index.createVirtual("none", h5::Type::int64, {4}, {}).shape(), (h5::Shape{0, 4}));
}

TEST_F(H5, FailuresSayWhatAndWhere)
{
  ::testing::internal::CaptureStderr();
  std::string message;
  try {
    h5::File::open(directory / "none.h5");
  } catch (h5::Error const& error) {
    message = error.what();
  }
  EXPECT_TRUE(test::contains(message, "Opening " + (directory / "none.h5").string())) << message;
  EXPECT_TRUE(test::contains(message, "HDF5: ")) << message;
  auto file = h5::File::create(path());
  EXPECT_THROW(file.openDataset("none"), h5::Error);
  EXPECT_THROW(file.textAttribute("none"), h5::Error);
  file.create("twice", h5::Type::int64, {1});
  EXPECT_THROW(file.create("twice", h5::Type::int64, {1}), h5::Error);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), ""); // HDF5's own error stack is silent
}
