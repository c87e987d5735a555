#include "parameters/fields/Field.hpp"

#include "parameters/fields/TimesInFormula.hpp"
#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <hdf5.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

namespace
{
using namespace asperity;
using namespace asperity::test;

const std::vector<std::string> regions = {"upper", "lower"};
constexpr std::array<double, 3> origin = {0.0, 0.0, 0.0};

// A list completed against a declaration of "a" in the range.
template <class T>
ParameterList listWith(T const& value, Range range = Range::any())
{
  ParameterList list;
  list.set("a", value);
  completeAndValidate(list,
                      *Declare()
                         .field("a", required, "-", range, "A.")
                         .hint("Typical values are 0.005 to 0.03.")
                         .list(),
                      "Friction");
  return list;
}

template <class T>
Field fieldOf(T const& value, Range range = Range::any())
{
  return Field(listWith(value, range), "a", "Friction", regions);
}

Field expression(std::string const& text, Range range = Range::any())
{
  return fieldOf(text, range);
}

TEST(Field, RefusesAnAssignmentInAnExpression)
{
  for (char const* text : {"x=0 ? 5e6 : 4e6", "(x=3)*0 + x", "x <= 1 && y = 2", "x===1"}) {
    expectRefusal([&] { expression(text); }, {"Friction / a = '", "single =", "=="});
  }
  EXPECT_EQ(expression("x == 0 && y <= 1 && y >= -1 && z != 1 ? 5 : 4")(origin, 0.0, 0), 5.0);
}

// mean(f) is the mean of f over the patch, everything around it is that of the point.
TEST(Field, TakesMeansOverAPatch)
{
  const std::array<std::array<double, 3>, 3> places = {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}};
  const std::array<double, 3> weights = {0.5, 0.25, 0.25};
  const Expression::Patch patch = {places.data(), weights.data(), 3};
  const auto at = [&patch](std::string const& text) {
    return expression(text)({2, 5, 0}, 10, 0, patch);
  };
  EXPECT_DOUBLE_EQ(at("mean(x)"), 1);
  EXPECT_DOUBLE_EQ(at("x + y * mean ( x^2 ) - mean((x > 0.5) * t)"), 2 + 5 * 2.5 - 5);
  EXPECT_DOUBLE_EQ(at("mean(max(x, mean(x)))"), 1); // within a mean, a mean is the value
  EXPECT_EQ(at("mean(0.1)"), 0.1);
  EXPECT_DOUBLE_EQ(at("mean(x)+mean(x)+mean(x)+mean(x)+mean(x)+mean(x)+mean(x)+mean(x)+mean(x)"
                      "+mean(x)+mean(2*x)"),
                   12);
  EXPECT_TRUE(expression("mean(x)").takesMeans());
  EXPECT_FALSE(expression("x").takesMeans());
  EXPECT_TRUE(expression("mean(t)").dependsOnTime());
  EXPECT_EQ(expression("mean(x) + x")({2, 0, 0}, 0, 0), 4); // without a patch
  EXPECT_EQ(Expression::constants("2 * mean(3), mean(1)", "a"), (std::vector<double>{6, 1}));
}

TEST(Field, NamesTheMistakeInAMean)
{
  expectRefusal([] { expression("1 + mean(x"); }, {"Friction / a = '1 + mean(x'"});
  expectRefusal([] { expression("mean(x + depth)"); }, {"Friction / a", "depth"});
  expectRefusal([] { expression("2 * mean(x, y)"); }, {"Friction / a", "2 values"});
  expectRefusal([] { expression("mean(x) + depth"); }, {"character 11"});
}

TEST(Field, Number)
{
  const Field field = fieldOf(2.5);
  EXPECT_EQ(field(origin, 0.0, 0), 2.5);
  EXPECT_FALSE(field.dependsOnTime());
  EXPECT_FALSE(field.isDataset());
  EXPECT_EQ(Field::constant(3.0)(origin, 0.0, 7), 3.0);
}

TEST(Field, ExpressionInSpaceAndTime)
{
  const Field field = expression("x + 10*y + 100*z + 1000*t");
  EXPECT_DOUBLE_EQ(field({1, 2, 3}, 4, 0), 4321.0);
  EXPECT_TRUE(field.dependsOnTime());
  EXPECT_FALSE(expression("x*y").dependsOnTime());
}

TEST(Field, FunctionsConstantsAndConditions)
{
  EXPECT_DOUBLE_EQ(expression("cos(pi) + e*0")(origin, 0, 0), -1.0);
  EXPECT_DOUBLE_EQ(expression("x < 0.3 && x > 0.1 ? 0.02 : 0.01")({0.2, 0, 0}, 0, 0), 0.02);
  EXPECT_DOUBLE_EQ(expression("if(x < 0.3, 1, 2)")({0.4, 0, 0}, 0, 0), 2.0);
  EXPECT_DOUBLE_EQ(expression("min(1, x, 3) + max(x, 2)")({0.5, 0, 0}, 0, 0), 2.5);
  EXPECT_DOUBLE_EQ(expression("tanh(x) + exp(x) + ln(x)")({1, 0, 0}, 0, 0),
                   std::tanh(1.0) + std::exp(1.0));
  EXPECT_DOUBLE_EQ(expression("x^2 + floor(1.7) + ceil(0.2) + abs(-1)")({3, 0, 0}, 0, 0), 12.0);
}

TEST(Field, ExpressionWithoutVariables)
{
  EXPECT_EQ(expression("1 - 1")(origin, 0, 0), 0);
  EXPECT_DOUBLE_EQ(expression("2*pi")({1, 2, 3}, 4, 0), 2 * M_PI);
  EXPECT_FALSE(expression("2*pi").dependsOnTime());
}

TEST(Field, ValuePerRegion)
{
  ParameterList list;
  list.sublist("a").set("lower", std::string("1 + t")).set("upper", 7);
  const Field field(list, "a", "Friction", regions);
  EXPECT_EQ(field(origin, 2.0, 0), 7.0);
  EXPECT_EQ(field(origin, 2.0, 1), 3.0);
  EXPECT_TRUE(field.dependsOnTime());
}

TEST(Field, ValuePerFault)
{
  const std::vector<std::string> faults = {"main", "splay", "lower"};
  ParameterList list;
  list.sublist("a").set("splay", std::string("1 + t")).set("main", 7).set("lower", 2.0);
  const Field field(list, "a", "Friction", regions, {}, faults);
  EXPECT_TRUE(field.isPerFault());
  EXPECT_EQ(field(origin, 2.0, 0), 7.0);
  EXPECT_EQ(field(origin, 2.0, 1), 3.0);
  EXPECT_EQ(field(origin, 2.0, 2), 2.0);
  // A list whose names are all regions is one of regions.
  ParameterList of_regions;
  of_regions.sublist("a").set("lower", 4.0).set("upper", 5.0);
  const Field per_region(of_regions, "a", "Friction", regions, {}, faults);
  EXPECT_FALSE(per_region.isPerFault());
  EXPECT_EQ(per_region(origin, 0, 0), 5.0);
  EXPECT_EQ(per_region(origin, 0, 1), 4.0);
}

TEST(Field, FaultsMustBeThoseOfTheModel)
{
  const auto refused = [](std::vector<std::string> const& names) {
    ParameterList list;
    for (auto const& name : names) {
      list.sublist("a").set(name, 1.0);
    }
    return refusal([&] { Field(list, "a", "Friction", regions, {}, {"main", "splay"}); });
  };
  expectParts(refused({"main", "spaly"}),
              {"Friction / a / spaly: 'spaly' is neither a region of the mesh nor a fault.",
               "Did you mean 'splay'?"});
  expectParts(refused({"main"}), {"Friction / a has no value for the fault 'splay'",
                                  "has the faults 'main', 'splay', the list has 'main'"});
  expectParts(refused({"main", "splay", "upper"}),
              {"Friction / a names regions and faults", "each region, 'upper', 'lower'"});
  expectParts(refused({"upper"}), {"no value for the region 'lower'"});
}

TEST(Field, CopiesGiveTheSameValues)
{
  const Field field = expression("x + t");
  const Field copy = field; // NOLINT(performance-unnecessary-copy-initialization): the test
  EXPECT_EQ(copy({1, 0, 0}, 2, 0), 3.0);
  EXPECT_EQ(field({5, 0, 0}, 2, 0), 7.0);
}

TEST(Field, RegionsMustBeThoseOfTheMesh)
{
  ParameterList misspelled;
  misspelled.sublist("a").set("uper", 1.0).set("lower", 1.0);
  expectRefusal([&] { Field(misspelled, "a", "Friction", regions); },
                {"Friction / a / uper", "not a region", "Did you mean 'upper'?"});
  ParameterList missing;
  missing.sublist("a").set("upper", 1.0);
  expectRefusal([&] { Field(missing, "a", "Friction", regions); },
                {"Friction / a", "no value for the region 'lower'", "'upper', 'lower'"});
  expectRefusal([&] { Field(missing, "b", "Friction", regions); }, {"Friction / b is missing"});
}

TEST(Field, BadExpressionsNameThePlace)
{
  expectRefusal([] { expression("1 + foo*x"); },
                {"Friction / a = '1 + foo*x'", "foo", "character 5"});
  expectRefusal([] { expression("2*(x + 1"); }, {"Friction / a", "parenthesis"});
  expectRefusal([] { expression("1 +"); }, {"Friction / a = '1 +'"});
  expectRefusal([] { expression(""); }, {"Friction / a = ''"});
  expectRefusal([] { expression("sin(x, y)"); }, {"Friction / a", "sin"});
  expectRefusal([] { expression("1, 5"); }, {"Friction / a = '1, 5'", "2 values"});
  ParameterList list;
  list.sublist("a").set("upper", 1.0).set("lower", std::string("q"));
  expectRefusal([&] { Field(list, "a", "Friction", regions); }, {"Friction / a / lower = 'q'"});
}

TEST(Field, RangeHoldsWhereverItIsEvaluated)
{
  const Field field = expression("0.01 - x", Range::positive());
  EXPECT_DOUBLE_EQ(field(origin, 0, 0), 0.01);
  expectRefusal(
    [&] {
      field({0.5, -2, 0}, 3, 0);
    },
    {"Friction / a = '0.01 - x' is -0.49", "(0.5, -2, 0) m", "t = 3 s", "(0, inf)",
     "Typical values are 0.005 to 0.03."});
  expectRefusal([] { expression("1 - 2", Range::positive()); }, {"Friction / a", "-1", "(0, inf)"});
}

TEST(Field, NoNanNoInfinity)
{
  expectRefusal([] { expression("1/x")(origin, 0, 0); }, {"Friction / a", "inf", "(0, 0, 0) m"});
  expectRefusal(
    [] {
      expression("sqrt(x)")({-1, 0, 0}, 0, 0);
    },
    {"Friction / a", "nan", "(-1, 0, 0) m"});
}

TEST(Field, CopiedListKeepsTheRange)
{
  const ParameterList copy = listWith(std::string("x"), Range::positive());
  const Field field(copy, "a", "Friction", regions);
  expectRefusal([&] { field({-1, 0, 0}, 0, 0); }, {"(0, inf)"});
}

// Evaluating a constant must cost next to nothing: it stands in loops over all vertices and steps.
TEST(Field, ConstantsAreCheap)
{
  if (std::getenv("ASPERITY_SANITIZER")) {
    GTEST_SKIP() << "With a sanitizer nothing is cheap.";
  }
  const Field field = fieldOf(1.5);
  const auto start = std::chrono::steady_clock::now();
  double sum = 0.0;
  constexpr int calls = 1000000;
  for (int i = 0; i < calls; ++i) {
    sum += field({i * 1e-6, 0, 0}, 0, i & 1);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(sum, 1.5 * calls);
  EXPECT_LT(elapsed.count() / calls, 100e-9);
  RecordProperty("nanoseconds_per_call", static_cast<int>(elapsed.count() / calls * 1e9));
}

void writeDataset(std::string const& file_name, std::string const& name,
                  std::vector<double> const& values, std::vector<hsize_t> const& shape)
{
  const hid_t file = H5Fcreate(file_name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t links = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(links, 1);
  const hid_t dataset =
    H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, links, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(dataset);
  H5Pclose(links);
  H5Sclose(space);
  H5Fclose(file);
}

TEST(TimesInFormula, AreThoseWithWhichItComparesT)
{
  using Times = std::vector<double>;
  EXPECT_EQ(timesComparedIn("t > 3000 && t < 3010 ? 4e-4 : 1e-9"), (Times{3000, 3010}));
  EXPECT_EQ(timesComparedIn("(2 * (3 + 4) <= t) * x"), (Times{14}));
  EXPECT_EQ(timesComparedIn("if(t>=1e3, max(t < -5, 0), y < 7 || t < pi * x)"), (Times{1e3, -5}));
  EXPECT_EQ(timesComparedIn("t - 3 > 2 && (t) < 6 && 5 - t < 1 && 1 + t > 8"), (Times{5, 6, 4, 7}));
  EXPECT_EQ(timesComparedIn("abs(t - 20) < 15 || 3 >= abs(10 - t)"), (Times{5, 35, 13, 7}));
  EXPECT_EQ(timesComparedIn("2 * t > 6 || t - x > 0 || t == 4 || abs(t - 5) + 1 < 3"), Times{});
  EXPECT_EQ(timesComparedIn("3"), Times{});
  EXPECT_EQ(timesComparedIn("t < "), Times{});
}

TEST(TimesInFormula, AreThoseOfPulses)
{
  using Times = std::vector<double>;
  EXPECT_EQ(timesShiftedIn("exp(-((t - 5.3e6) / 10)^2) / (10 * sqrt(pi))"), Times{5.3e6});
  EXPECT_EQ(timesShiftedIn("max(0, 1 - abs(60 - t) / 5) + x * sin(t + 2 * 3)"), (Times{60, -6}));
  EXPECT_EQ(timesShiftedIn("wall-t"), Times{}); // the name of a boundary
  EXPECT_EQ(timesShiftedIn("sin(2 * pi * t) + t * (x - t) + 2 * t - 3 + tanh(t)"), Times{});
}

TEST(FieldDataset, ValuesByGlobalId)
{
  const TemporaryDirectory directory;
  const auto file = directory.file("field.h5");
  std::vector<double> values(300000); // several blocks
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = 0.5 * static_cast<double>(i);
  }
  writeDataset(file, "a", values, {values.size()});
  const Field field = fieldOf(file + ":/a", Range::atLeast(0));
  EXPECT_TRUE(field.isDataset());
  EXPECT_EQ(field.values({299999, 0, 131072, 7, 7}, 300000),
            (std::vector<double>{149999.5, 0, 65536, 3.5, 3.5}));
  EXPECT_TRUE(field.values({}, 300000).empty());
  for (long long of_another_mesh : {299999, 300001}) {
    expectRefusal([&] { field.values({3}, of_another_mesh); },
                  {"Friction / a", "300000 values", std::to_string(of_another_mesh) + " vertices"});
  }
}

TEST(FieldDataset, Refusals)
{
  const TemporaryDirectory directory;
  const auto file = directory.file("field.h5");
  writeDataset(file, "a", {1, -2, 3, 4}, {4});
  expectRefusal(
    [&] {
      fieldOf(file + ":/a", Range::positive()).values({0, 1}, 4);
    },
    {"Friction / a", "-2", "vertex 1", "(0, inf)"});
  expectRefusal([&] { fieldOf(file + ":/b"); },
                {"Friction / a", "no dataset '/b'", "Did you mean '/a'?"});
  expectRefusal([&] { fieldOf(directory.file("none.h5") + ":/a"); },
                {"Friction / a", "no file", "none.h5", "has no such file"});
  expectRefusal([&] { fieldOf(directory.file("feild.h5") + ":/a"); },
                {"has no such file. Did you mean 'field.h5'?"});
  expectRefusal([&] { fieldOf(directory.file("data/field.h5") + ":/a"); },
                {"data does not exist; "});
  expectRefusal([&] { fieldOf("none/field.h5:/a"); }, {"relative to the deck's folder"});
  writeDataset(file, "layer/b", {1, 2}, {2});
  expectRefusal([&] { fieldOf(file + ":/layer"); },
                {"Friction / a", "'/layer' is a group, not a dataset", "It has 'b'."});
  for (std::string const name :
       {"friction.csv", "data/friction.nc", "a.txt", "s.h5:good", "s.h5/good"}) {
    expectRefusal([&] { fieldOf(name); }, {"Friction / a = '" + name + "'", "name of a file",
                                           "'file.h5:/dataset'", "one number for each vertex"});
  }
  expectRefusal([&] { fieldOf("1.5e"); }, {"no valid expression"});
  const auto text = directory.write("text.h5", "not HDF5");
  expectRefusal([&] { fieldOf(text + ":/a"); }, {"Friction / a", "cannot be read as an HDF5 file"});
  writeDataset(file, "square", {1, 2, 3, 4}, {2, 2});
  expectRefusal([&] { fieldOf(file + ":/square"); }, {"Friction / a", "one-dimensional"});
}
} // namespace
