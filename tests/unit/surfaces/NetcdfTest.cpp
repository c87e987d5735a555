#include "SurfaceSamples.hpp"

#include "surfaces/grids/GridFile.hpp"
#include "surfaces/netcdf/NetcdfClassic.hpp"
#include "surfaces/netcdf/UntrustedWork.hpp"

#include "hdf5/File.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sys/mman.h>

using namespace asperity;
using namespace asperity::geometry;

namespace
{
// Writes netCDF's classic format, of version 1, 2 or 5.
class ClassicWriter
{
public:
  explicit ClassicWriter(int version) : version_(version) {}

  std::string count(std::uint64_t n) const
  {
    return version_ == 5 ? bytes<std::uint64_t>(n, true)
                         : bytes(static_cast<std::uint32_t>(n), true);
  }
  std::string name(std::string const& text) const { return count(text.size()) + padded(text); }
  static std::string tag(std::uint32_t number) { return bytes(number, true); }
  static std::string padded(std::string text)
  {
    text.resize((text.size() + 3) / 4 * 4, '\0');
    return text;
  }
  std::string textAttribute(std::string const& key, std::string const& value) const
  {
    return name(key) + tag(2) + count(value.size()) + padded(value);
  }
  std::string numberAttribute(std::string const& key, float value) const
  {
    return name(key) + tag(5) + count(1) + bytes(value, true);
  }
  std::string offset(std::uint64_t n) const
  {
    return version_ == 1 ? bytes(static_cast<std::uint32_t>(n), true) : bytes(n, true);
  }
  std::string magic() const { return std::string("CDF") + static_cast<char>(version_); }

private:
  int version_;
};

struct ClassicVariable
{
  std::string name;
  std::vector<int> dimensions;
  std::string attributes; // with their tag and count
  std::uint32_t type;
  std::string values;
  bool is_record = false;
};

// dims: lon 3, lat 2, length 5, time unlimited with 2 records. z(lat, lon) is packed in 16 bits;
// a(time, lon) and b(time) are interleaved.
std::string classicFile(int version)
{
  const ClassicWriter w(version);
  const std::string none = w.tag(0) + w.count(0);
  const auto doubles = [](std::vector<double> const& values) {
    std::string text;
    for (const double value : values) {
      text += bytes(value, true);
    }
    return text;
  };
  const auto shorts = [](std::vector<int> const& values) {
    std::string text;
    for (const int value : values) {
      text += bytes(static_cast<std::int16_t>(value), true);
    }
    return text;
  };
  std::vector<ClassicVariable> variables = {
    {"lon",
     {0},
     w.tag(12) + w.count(1) + w.textAttribute("units", "degrees_east"),
     6,
     doubles({232, 233, 234})},
    {"lat",
     {1},
     w.tag(12) + w.count(1) + w.textAttribute("units", "degrees_north"),
     6,
     doubles({41, 40})},
    {"depth",
     {1, 0},
     w.tag(12) + w.count(5) + w.textAttribute("units", "km") + w.textAttribute("positive", "down") +
       w.numberAttribute("scale_factor", 0.5) + w.numberAttribute("add_offset", 10) +
       w.numberAttribute("missing_value", -1),
     3,
     shorts({2, 4, 6, 8, 10, -1})},
    {"names", {1, 2}, none, 2, "main splay"},
    {"a", {3, 0}, none, 3, shorts({1, 2, 3}), true},
    {"b", {3}, none, 4, bytes<std::int32_t>(70000, true), true}};
  std::string header = w.magic() + w.count(2) + w.tag(10) + w.count(4);
  header += w.name("lon") + w.count(3) + w.name("lat") + w.count(2) + w.name("length") +
            w.count(5) + w.name("time") + w.count(0);
  header += w.tag(12) + w.count(1) + w.textAttribute("title", "made by a test");
  header += w.tag(11) + w.count(variables.size());
  const auto withOffsets = [&](std::uint64_t begin) {
    std::string text;
    for (auto const& each : variables) {
      text += w.name(each.name) + w.count(each.dimensions.size());
      for (const int d : each.dimensions) {
        text += w.count(static_cast<std::uint64_t>(d));
      }
      const auto size = w.padded(each.values).size();
      text += each.attributes + w.tag(each.type) + w.count(size) + w.offset(begin);
      begin += size;
    }
    return text;
  };
  std::string file = header + withOffsets(header.size() + withOffsets(0).size());
  std::string record, next;
  for (auto const& each : variables) {
    file += w.padded(each.values);
    record += each.is_record ? w.padded(each.values) : "";
  }
  next = record; // the second record: a = 4 5 6, b = 70001
  next.replace(0, 8, w.padded(shorts({4, 5, 6})));
  next.replace(8, 4, bytes<std::int32_t>(70001, true));
  return file + next;
}

using Netcdf = FileTest;

void storeAxis(h5::File& file, std::string const& name, std::vector<double> const& values,
               std::string const& attribute, std::string const& text)
{
  auto axis = file.store(name, values.data(), {values.size()});
  axis.setAttribute("CLASS", "DIMENSION_SCALE");
  if (!attribute.empty()) {
    axis.setAttribute(attribute, text);
  }
}
} // namespace

TEST_F(Netcdf, ClassicOfEveryVersion)
{
  for (const int version : {1, 2, 5}) {
    const NetcdfClassic classic(write("a.nc", classicFile(version)), "Grid file");
    EXPECT_EQ(classic.attributes().at("title").text, "made by a test") << version;
    EXPECT_EQ(classic.dimensions().at("time"), 2u);
    EXPECT_EQ(classic.variable("depth").dimensions, (std::vector<std::string>{"lat", "lon"}));
    EXPECT_EQ(classic.numbers("lon"), (std::vector<double>{232, 233, 234}));
    EXPECT_EQ(classic.texts("names"), (std::vector<std::string>{"main", "splay"}));
    EXPECT_EQ(classic.numbers("a"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(classic.numbers("b"), (std::vector<double>{70000, 70001}));
    test::expectRefusal([&] { classic.numbers("names"); }, {"'names'", "characters"});
    test::expectRefusal([&] { classic.numbers("dept"); }, {"'dept'", "Did you mean 'depth'?"});
  }
}

TEST_F(Netcdf, ClassicGridByCf)
{
  const auto file_name = write("a.nc", classicFile(1));
  const auto data = readGrid(file_name, "depth");
  EXPECT_EQ(data.horizontal_unit, "degrees");
  EXPECT_EQ(data.vertical_unit, 1000);
  EXPECT_TRUE(data.is_depth);
  EXPECT_EQ(data.grid(-128, 41), 11);
  EXPECT_EQ(data.grid(-127, 40), 15);
  EXPECT_TRUE(std::isnan(data.grid.z(2, 0)));
  test::expectRefusal([&] { readGrid(file_name); }, {"several grids: 'depth', 'a'", "Variable"});
  test::expectRefusal([&] { readGrid(file_name, "lon"); },
                      {"'lon'", "not a grid of two dimensions"});
}

TEST_F(Netcdf, ClassicThatIsDamagedIsRefusedAndTakesNoMemory)
{
  const std::string whole = classicFile(2);
  // Every byte of the header in turn, by the largest value, and every length of the file.
  std::size_t num_refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = '\xff';
    const auto path = write("bad.nc", i % 2 == 0 ? damaged : whole.substr(0, i));
    try {
      const NetcdfClassic classic(path, "Grid file");
      for (auto const& each : classic.variables()) {
        if (!each.is_text) {
          classic.numbers(each.name);
        }
      }
    } catch (InputError const& error) {
      ++num_refused;
      EXPECT_NE(std::string(error.what()).find("bad.nc"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(num_refused, whole.size() / 3);
  test::expectRefusal([&] { readGrid(write("c.nc", "hello")); }, {"neither CDF nor HDF"});
  test::expectRefusal([&] { readGrid(write("d.nc", std::string("CDF\7") + whole.substr(4))); },
                      {"version 1, 2 or 5"});
  test::expectRefusal([&] { readGrid(write("e.nc", "\x89HDF\r\n\x1a\n damaged")); },
                      {"e.nc", "cut or damaged"});
}

TEST_F(Netcdf, OfHdf5)
{
  const std::vector<double> lon = {-128, -127, -126}, lat = {49, 48};
  const std::vector<float> z = {1, 2, 3, 4, std::nanf(""), 6};
  const auto path = file("a.grd");
  {
    auto made = h5::File::create(path);
    storeAxis(made, "lon", lon, "units", "degrees_east");
    storeAxis(made, "lat", lat, "standard_name", "latitude");
    auto values = made.store("elevation", z.data(), {2, 3});
    values.setAttribute("units", "meters");
    values.setAttribute("_FillValue", std::vector<double>{6});
    made.createTexts("crs", {"WGS 84"});
    made.close();
  }
  const auto data = readGrid(path);
  EXPECT_EQ(data.horizontal_unit, "degrees");
  EXPECT_EQ(data.vertical_unit, 1);
  EXPECT_FALSE(data.is_depth);
  EXPECT_EQ(data.grid(-128, 49), 1);
  EXPECT_EQ(data.grid(-128, 48.5), 2.5);
  EXPECT_TRUE(std::isnan(data.grid.z(1, 0)));
  EXPECT_TRUE(std::isnan(data.grid.z(2, 0)));
  test::expectRefusal([&] { readGrid(path, "lon"); }, {"'lon'", "two dimensions"});
}

// Cut files, and each byte around the tables of groups, around attributes, which are texts of
// variable length, and at the beginning of the heap with these texts: a grid or a message with the
// file's name. HDF5 1.10.8 crashes on some of these files.
TEST_F(Netcdf, OfHdf5ThatIsDamaged)
{
  const auto path = file("whole.nc");
  const std::vector<double> x = {0, 10}, y = {0, 1}, z = {1, 2, 3, 4};
  {
    auto made = h5::File::create(path);
    storeAxis(made, "x", x, "units", "km");
    storeAxis(made, "y", y, "units", "km");
    made.store("h", z.data(), {2, 2});
    made.close();
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(stream)), {});
  ASSERT_GT(whole.size(), 500u);
  const auto read = [&](std::string const& content) {
    try {
      readGrid(write("bad.nc", content));
      return true;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find("bad.nc"), std::string::npos) << error.what();
      return false;
    }
  };
  ASSERT_TRUE(read(whole));
  for (std::size_t size = 0; size < whole.size(); size += 16) {
    EXPECT_FALSE(read(whole.substr(0, size))) << size;
  }
  int num_refused = 0;
  for (auto const* part : {"HEAP", "TREE", "SNOD", "CLASS", "units", "GCOL"}) {
    for (auto at = whole.find(part); at != std::string::npos; at = whole.find(part, at + 1)) {
      for (std::size_t i = at - 16; i < std::min(at + 40, whole.size()); ++i) {
        std::string damaged = whole;
        damaged[i] = '\xff';
        num_refused += read(damaged) ? 0 : 1;
      }
    }
  }
  EXPECT_GT(num_refused, 20);
}

TEST(UntrustedWork, EndsOrCrashesInATrial)
{
  constexpr std::uint64_t seconds = 1;
  int changed = 0;
  EXPECT_TRUE(endsInATrial([&] { changed = 1; }, seconds));
  EXPECT_EQ(changed, 0); // in the copy alone
  EXPECT_TRUE(endsInATrial([] { throw InputError("wrong"); }, seconds));
  EXPECT_FALSE(endsInATrial([] { std::raise(SIGSEGV); }, seconds));
  EXPECT_FALSE(endsInATrial([] { std::abort(); }, seconds));
  EXPECT_FALSE(endsInATrial(
    [&] {
      for (volatile int i = 0; i >= 0; i = 1 - i) {
      }
    },
    seconds));
}

TEST(UntrustedWork, HasLimitedMemory)
{
  constexpr std::size_t much = std::size_t(1) << 30;
  const auto take = [] {
    return ::mmap(nullptr, much, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  };
  {
    const MemoryLimit limit(much / 2);
    EXPECT_EQ(take(), MAP_FAILED);
  }
  void* const memory = take();
  ASSERT_NE(memory, MAP_FAILED);
  ::munmap(memory, much);
}

TEST_F(Netcdf, OfHdf5InOtherOrders)
{
  const std::vector<double> x = {0, 10, 20}, y = {0, 1};
  const std::vector<double> z = {0, 1, 10, 11, 20, 21}; // (x, y), x + y
  const auto path = file("a.nc");
  {
    auto made = h5::File::create(path);
    storeAxis(made, "x", x, "units", "km");
    storeAxis(made, "y", y, "units", "km");
    made.store("h", z.data(), {1, 3, 2});
    made.close();
  }
  const auto data = readGrid(path);
  EXPECT_EQ(data.horizontal_unit, "km");
  EXPECT_EQ(data.vertical_unit, 0);
  EXPECT_EQ(data.grid(15, 0.5), 15.5);
  {
    auto made = h5::File::create(path);
    storeAxis(made, "first", x, "", "");
    storeAxis(made, "second", y, "", "");
    made.store("h", z.data(), {3, 2});
    made.close();
  }
  test::expectRefusal([&] { readGrid(path); }, {"'first' and 'second'", "standard_name"});
  {
    auto made = h5::File::create(path);
    storeAxis(made, "x", {0, 10}, "", "");
    storeAxis(made, "y", {5, 6}, "", "");
    made.store("square", z.data(), {2, 2});
    made.close();
  }
  EXPECT_EQ(readGrid(path).grid(10, 5), 1);
  {
    auto made = h5::File::create(path);
    made.store("h", z.data(), {3, 2});
    made.close();
  }
  test::expectRefusal([&] { readGrid(path); }, {"variable 'h'", "no coordinates"});
}
