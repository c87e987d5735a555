#include "hdf5/File.hpp"
#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <cmath>
#include <fstream>

using namespace asperity;

namespace
{
// Every rank uses files of its own.
class H5 : public ::testing::Test
{
protected:
  std::filesystem::path path(std::string const& name = "file") const
  {
    return directory.file(name + ".h5");
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
  EXPECT_EQ(file.openDataset("a/b/real").read<double>(), values);
  EXPECT_EQ(file.openDataset("a/single").read<std::int64_t>(), std::vector<std::int64_t>{large});
  EXPECT_TRUE(file.openDataset("a/single").shape().empty());
  EXPECT_EQ(file.openDataset("a/none").shape(), (h5::Shape{0, 2}));
  EXPECT_TRUE(file.openDataset("a/none").read<double>().empty());
  EXPECT_TRUE(file.has("a/b/real"));
  EXPECT_FALSE(file.has("a/c/real"));
  EXPECT_EQ(file.openGroup("a").names(), (std::vector<std::string>{"b", "none", "single"}));
}

TEST_F(H5, RowsAreAppended)
{
  const std::vector<double> rows{1, 2, 3, 4, 5, 6};
  auto file = h5::File::create(path());
  auto dataset = file.createExtendable("v", h5::Type::float32, {2}, 4);
  dataset.appendPart(rows.data(), 1, {0, 2});
  dataset.appendPart(rows.data() + 2, 2, {0, 2});
  EXPECT_EQ(dataset.shape(), (h5::Shape{3, 2}));
  EXPECT_EQ(dataset.read<double>(), rows);
  EXPECT_EQ(dataset.type(), h5::Type::float32);
}

TEST_F(H5, RowsAreFilledPartByPart)
{
  auto file = h5::File::create(path());
  auto dataset = file.createExtendable("v", h5::Type::float64, {3}, 4);
  dataset.appendPart(std::vector<double>{1, 2, 3}.data(), 1, {0, 3});
  dataset.extend(2);
  dataset.writeRows(std::vector<double>{4, 7}.data(), 2, {0, 1});
  dataset.writeRows(std::vector<double>{5, 6, 8, 9}.data(), 2, {1, 2});
  EXPECT_EQ(dataset.read<double>(), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST_F(H5, AFileIsOpenedForWritingAgain)
{
  {
    auto file = h5::File::create(path());
    file.create("rows", h5::Type::int64, {3, 2});
    file.close();
  }
  const std::vector<std::int64_t> rows{1, 2, 3, 4};
  auto file = h5::File::openForWriting(path());
  file.openDataset("rows").writePart(rows.data(), {1, 2});
  file.close();
  const auto reading = h5::File::open(path());
  std::vector<std::int64_t> back(4);
  reading.openDataset("rows").readPart(back.data(), {1, 2});
  EXPECT_EQ(back, rows);
}

TEST_F(H5, VirtualDatasetJoinsFilesAndSkipsEmptyParts)
{
  for (int part = 0; part < 2; ++part) {
    auto file = h5::File::create(path("part" + std::to_string(part) + "_"));
    const std::vector<double> rows{10.0 * part, 10.0 * part + 1};
    file.createExtendable("x/v", h5::Type::float64, {}, 8)
      .appendPart(rows.data(), part + 1, {0, 1});
  }
  auto index = h5::File::create(path("index"));
  const auto name = [&](int part) {
    return path("part" + std::to_string(part) + "_").filename().string();
  };
  auto joined =
    index.createVirtual("x/v", h5::Type::float64, {}, {{name(0), 1}, {"none.h5", 0}, {name(1), 2}});
  EXPECT_EQ(joined.shape(), h5::Shape{3});
  EXPECT_EQ(joined.read<double>(), (std::vector<double>{0, 10, 11}));
  auto torn = index.createVirtual("torn/v", h5::Type::float32, {}, {{"none.h5", 2}});
  EXPECT_TRUE(std::isnan(torn.read<double>()[1])); // HDF5 alone would say 0
  auto torn_steps = index.createVirtual("torn/n", h5::Type::int64, {}, {{"none.h5", 1}});
  EXPECT_EQ(torn_steps.read<std::int64_t>()[0], -1);
  EXPECT_EQ(index.createVirtual("none", h5::Type::int64, {4}, {}).shape(), (h5::Shape{0, 4}));
}

TEST_F(H5, AVirtualRowShowsComponentsOfARowAndZeros)
{
  const std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}; // (2, 3, 2)
  auto stored = h5::File::create(path("stored"));
  stored.createExtendable("f/u", h5::Type::float64, {3, 2}, 8).appendPart(values.data(), 2, {0, 3});
  stored.close();
  h5::VirtualRow row;
  row.file = path("stored").filename().string();
  row.path = "/f/u";
  row.shape = {2, 3, 2};
  row.row = 1;
  row.points = 2; // of three
  row.columns = {1, 0, -1, 0, 1};
  auto shown = h5::File::create(path("shown"));
  const auto columns = shown.createVirtualRow("u/1", h5::Type::float64, row);
  EXPECT_EQ(columns.shape(), (h5::Shape{2, 5}));
  EXPECT_EQ(columns.read<double>(), (std::vector<double>{8, 7, 0, 7, 8, 10, 9, 0, 9, 10}));
  row.columns = {1};
  const auto scalar = shown.createVirtualRow("v/1", h5::Type::float64, row);
  EXPECT_EQ(scalar.shape(), h5::Shape{2});
  EXPECT_EQ(scalar.read<double>(), (std::vector<double>{8, 10}));
  row.points = 0;
  EXPECT_EQ(shown.createVirtualRow("none", h5::Type::float64, row).shape(), h5::Shape{0});
}

TEST_F(H5, TextsOfFixedLengthReadBackFromASealedFile)
{
  const std::vector<std::string> texts{"left of it", "", "right"};
  {
    auto file = h5::File::create(path(), h5::Layout::sealed);
    file.setAttribute("format", "asperity", h5::TextLength::fixed);
    file.setAttribute("empty", "", h5::TextLength::fixed);
    file.createTexts("names", texts, h5::TextLength::fixed);
    file.close();
  }
  EXPECT_TRUE(h5::File::isSealed(path()));
  h5::File::create(path("plain")).close();
  EXPECT_FALSE(h5::File::isSealed(path("plain")));
  EXPECT_FALSE(h5::File::isSealed(path("none")));
  std::ofstream(path("text")) << "\x89HDF";
  EXPECT_FALSE(h5::File::isSealed(path("text")));
  const auto file = h5::File::open(path());
  EXPECT_EQ(file.openDataset("names").readTexts(), texts);
  EXPECT_EQ(file.textAttribute("format"), "asperity");
  EXPECT_EQ(file.textAttribute("empty"), "");
}

TEST_F(H5, NumbersOfAllTypesReadBack)
{
  const std::uint64_t largest = ~std::uint64_t(0);
  const long long id = 1LL << 40;
  const std::vector<int> numbers{-1, 2, 3, 4};
  auto file = h5::File::create(path());
  EXPECT_EQ(file.store("checksum", &largest, {1}).type(), h5::Type::uint64);
  EXPECT_EQ(file.store("id", &id, {1}).type(), h5::Type::int64);
  const auto dataset = file.store("numbers", numbers.data(), {2, 2});
  EXPECT_EQ(dataset.type(), h5::Type::int32);
  EXPECT_EQ(dataset.valueClass(), h5::ValueClass::integer);
  EXPECT_EQ(file.openDataset("checksum").read<std::uint64_t>()[0], largest);
  EXPECT_EQ(file.openDataset("id").read<long long>()[0], id);
  EXPECT_EQ(dataset.read<double>(), (std::vector<double>{-1, 2, 3, 4}));
  std::vector<int> row(2);
  dataset.readPart(row.data(), {1, 1});
  EXPECT_EQ(row, (std::vector<int>{3, 4}));
  EXPECT_THROW(dataset.readPart(row.data(), {1, 2}), h5::Error);
}

TEST_F(H5, AttributesOfAnotherKindAreRefused)
{
  auto file = h5::File::create(path());
  file.setAttribute("text", "a");
  file.setAttribute("integer", 3);
  file.setAttribute("period", std::vector<double>{0, 2.5});
  EXPECT_TRUE(file.hasAttribute("period"));
  EXPECT_FALSE(file.hasAttribute("none"));
  EXPECT_EQ(file.numbersAttribute("period"), (std::vector<double>{0, 2.5}));
  test::expectRefusal<h5::Error>([&] { file.integerAttribute("text"); },
                                 {"'text'", "not an integer"});
  test::expectRefusal<h5::Error>([&] { file.integerAttribute("period"); }, {"not an integer"});
  test::expectRefusal<h5::Error>([&] { file.textAttribute("integer"); },
                                 {"'integer'", "not a text"});
  test::expectRefusal<h5::Error>([&] { file.numbersAttribute("text"); }, {"not a list of numbers"});
}

TEST_F(H5, ALinkToNowhereIsNotThere)
{
  auto file = h5::File::create(path());
  file.createGroup("a/b");
  file.link("c", "none.h5");
  EXPECT_TRUE(file.has("/a/b"));
  EXPECT_FALSE(file.has("a/c"));
  EXPECT_FALSE(file.has("c"));
}

TEST_F(H5, FailuresSayWhatAndWhere)
{
  ::testing::internal::CaptureStderr();
  const std::string none = path("none").string();
  test::expectRefusal<h5::Error>([&] { h5::File::open(none); },
                                 {"Opening " + none, "No such file"});
  auto file = h5::File::create(path());
  EXPECT_THROW(file.openDataset("none"), h5::Error);
  EXPECT_THROW(file.textAttribute("none"), h5::Error);
  EXPECT_FALSE(file.has("none/at/all"));
  file.create("twice", h5::Type::int64, {1});
  EXPECT_THROW(file.create("twice", h5::Type::int64, {1}), OutputError);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), ""); // HDF5's own error stack is silent
}

// A damaged file may have any bytes in its names.
TEST_F(H5, FailuresStayOnOneLine)
{
  auto file = h5::File::create(path());
  auto const message = test::refusal<h5::Error>([&] { file.openDataset("no\nsuch\vname"); });
  EXPECT_NE(message.find("no such name"), std::string::npos) << message;
  EXPECT_EQ(message.find_first_of("\n\v"), std::string::npos) << message;
}

// What other code in the process has told HDF5 to print is its own business.
TEST_F(H5, OthersHearOfTheirErrorsAsBefore)
{
  int num_reports = 0;
  const H5E_auto2_t report = [](hid_t, void* count) -> herr_t {
    ++*static_cast<int*>(count);
    return 0;
  };
  H5E_auto2_t before = nullptr;
  void* data_before = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &before, &data_before);
  H5Eset_auto2(H5E_DEFAULT, report, &num_reports);
  auto file = h5::File::create(path());
  EXPECT_THROW(file.openDataset("none"), h5::Error);
  EXPECT_THROW(h5::File::open(path("none")), h5::Error);
  EXPECT_FALSE(file.has("none"));
  EXPECT_EQ(num_reports, 0);
  H5Fopen("/no/file/at/all.h5", H5F_ACC_RDONLY, H5P_DEFAULT); // somebody else's call
  EXPECT_EQ(num_reports, 1);
  H5Eset_auto2(H5E_DEFAULT, before, data_before);
}
