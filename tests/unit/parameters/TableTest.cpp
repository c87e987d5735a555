#include "parameters/fields/TableFunction.hpp"

#include "parameters/fields/Expression.hpp"
#include "parameters/fields/TableFile.hpp"
#include "parameters/fields/Unit.hpp"
#include "unit/base/Refusal.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <cmath>
#include <limits>
#include <thread>

namespace
{
using namespace asperity;
using namespace asperity::test;
using Interpolation = TableRule::Interpolation;
using Outside = TableRule::Outside;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TableFunction table(std::vector<double> const& arguments, std::vector<double> const& values,
                    TableRule const& rule = {})
{
  return TableFunction({arguments, values}, rule, "Asperity / Tables / f");
}

TEST(TableFunction, ReproducesALinearProfile)
{
  const auto profile = [](double depth) { return 2600 + 0.0125 * depth; };
  std::vector<double> depths, values;
  for (const double depth : {0., 1e3, 4.5e3, 2e4, 3.5e4}) {
    depths.push_back(depth);
    values.push_back(profile(depth));
  }
  const auto f = table(depths, values);
  for (int i = 0; i <= 1000; ++i) {
    const double depth = 35. * i;
    EXPECT_NEAR(f(depth), profile(depth), 4 * std::numeric_limits<double>::epsilon() * 3100);
  }
  for (std::size_t row = 0; row < depths.size(); ++row) {
    EXPECT_EQ(f(depths[row]), values[row]);
  }
  EXPECT_TRUE(std::isnan(f(nan)));
}

TEST(TableFunction, HasTheValueOfGreaterArgumentsWhereItJumps)
{
  const auto linear = table({0, 1, 1, 3}, {10, 20, 30, 50});
  EXPECT_EQ(linear(1), 30);
  EXPECT_EQ(linear(0.5), 15);
  EXPECT_EQ(linear(2), 40);
  EXPECT_NEAR(linear(std::nextafter(1., 0.)), 20, 1e-12);
  const auto step = table({0, 1, 3}, {10, 20, 30}, {Interpolation::step});
  EXPECT_EQ(step(0), 10);
  EXPECT_EQ(step(std::nextafter(1., 0.)), 10);
  EXPECT_EQ(step(1), 20);
  EXPECT_EQ(step(std::nextafter(3., 0.)), 20);
  EXPECT_EQ(step(3), 30);
  const auto nearest = table({0, 1, 3}, {10, 20, 30}, {Interpolation::nearest});
  EXPECT_EQ(nearest(0.49), 10);
  EXPECT_EQ(nearest(0.5), 20);
  EXPECT_EQ(nearest(1.9), 20);
  EXPECT_EQ(nearest(2), 30);
  EXPECT_EQ(nearest(3), 30);
}

TEST(TableFunction, DoesOutsideWhatItIsTold)
{
  for (const auto how : {Interpolation::linear, Interpolation::nearest, Interpolation::step}) {
    const auto refuses = table({0, 1}, {10, 20}, {how, Outside::error});
    for (const double argument : {-1e-9, 1 + 1e-9, 1e300}) {
      expectRefusal([&] { refuses(argument); },
                    {"Asperity / Tables / f has arguments from 0 to 1, but ", "is wanted"});
    }
    EXPECT_EQ(refuses(-0.), 10);
    const auto stays = table({0, 1}, {10, 20}, {how, Outside::nearest});
    EXPECT_EQ(stays(-5), 10);
    EXPECT_EQ(stays(5), 20);
    const auto has_value = table({0, 1}, {10, 20}, {how, Outside::value, 7});
    EXPECT_EQ(has_value(-5), 7);
    EXPECT_EQ(has_value(5), 7);
    EXPECT_EQ(has_value(1), 20);
    EXPECT_TRUE(std::isnan(stays(nan)) && std::isnan(has_value(nan)));
  }
}

TEST(TableFunction, RefusesRowsThatMakeNoFunction)
{
  expectRefusal([] { table({}, {}); }, {"Asperity / Tables / f: a table needs two rows", "has 0"});
  expectRefusal([] { table({1}, {1}); }, {"has 1."});
  expectRefusal([] { table({0, 1, 2}, {1, 2}); }, {"3 arguments, but 2 values"});
  expectRefusal(
    [] {
      table({0, 2, 1}, {1, 2, 3});
    },
    {"row 3", "the argument 1 is less than 2", "Sort the rows"});
  expectRefusal([] { table({0, 1, 1, 1}, {1, 2, 3, 4}); }, {"row 4", "Two rows at most"});
  for (const auto how : {Interpolation::nearest, Interpolation::step}) {
    expectRefusal(
      [&] {
        table({0, 1, 1}, {1, 2, 3}, {how});
      },
      {"row 3", "Only Interpolation = Linear"});
  }
  expectRefusal([] { table({0, nan}, {1, 2}); }, {"row 2", "nan"});
  expectRefusal([] { table({0, 1}, {1, HUGE_VAL}); }, {"row 2", "inf"});
}

TEST(TableFunction, MayBeCalledByManyThreads)
{
  const auto f = table({0, 1, 2}, {0, 10, 0});
  std::vector<double> sums(4, 0);
  std::vector<std::thread> threads;
  for (double& sum : sums) {
    threads.emplace_back([&f, &sum] {
      for (int i = 0; i <= 20000; ++i) {
        sum += f(1e-4 * i);
      }
    });
  }
  for (auto& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(sums, std::vector<double>(4, sums[0]));
  EXPECT_NEAR(sums[0], 1e5, 1e-6);
}

TEST(Unit, ConvertsDecimalsToTheSameNumbersInSi)
{
  const auto si = [](double value, std::string const& unit) { return Unit(unit, "f").toSi(value); };
  EXPECT_EQ(si(2.67, "g/cm^3"), 2670);
  EXPECT_EQ(si(2.67, "kg/m^3"), 2.67);
  EXPECT_EQ(si(32.04, "GPa"), 32.04e9);
  EXPECT_EQ(si(7, "MPa"), 7e6);
  EXPECT_EQ(si(3.464, "km/s"), 3464);
  EXPECT_EQ(si(35.5, "km"), 35500);
  EXPECT_EQ(si(35.5, " km "), 35500);
  EXPECT_EQ(si(3, "mm"), 3e-3);
  EXPECT_DOUBLE_EQ(si(31557.6, "mm/a"), 1e-6);
  EXPECT_EQ(si(2, "h"), 7200);
  EXPECT_EQ(si(2, "min"), 120);
  EXPECT_EQ(si(1, "Ma"), 3.15576e13);
  EXPECT_EQ(si(1e19, "Pa s"), 1e19);
  EXPECT_EQ(si(5, "mW/m^2"), 5e-3);
  EXPECT_EQ(si(2.5, "W/m/K"), 2.5);
  EXPECT_EQ(si(4, "m^-1"), 4);
  EXPECT_EQ(si(4, "1/s"), 4);
  EXPECT_EQ(si(-3.3e300, "GPa"), -HUGE_VAL);
  EXPECT_EQ(si(0, "km"), 0);
  for (char const* of_pure_numbers : {"", "-", "1"}) {
    EXPECT_EQ(si(0.25, of_pure_numbers), 0.25);
  }
  EXPECT_EQ(Unit("kN/m^2", "f").powers(), Unit("Pa", "f").powers());
  EXPECT_NE(Unit("Pa s", "f").powers(), Unit("Pa/s", "f").powers());
}

TEST(Unit, RefusesWhatItDoesNotKnow)
{
  for (std::string const unit :
       {"feet",  "kilometres", "Km", "m3", "kg/m3", "g/cc", "bar", "deg",   "%",     "m^", "m^0",
        "m^1e3", "Pa*s",       "cs", "2",  "kmin",  "m/",   "/s",  "Pa  s", "m^2^2", "1/1"}) {
    expectRefusal([&] { Unit(unit, "Tables / f / Value Unit"); },
                  {"Tables / f / Value Unit: the unit '" + unit + "' is unknown", "as in kg/m^3"});
  }
  expectRefusal([] { Unit("W/m K", "f"); }, {"f: the unit 'W/m K'", "slash", "W/m/K"});
}

// A file with these lines.
class CrustFile
{
public:
  explicit CrustFile(std::string const& content) : name_(directory_.write("crust.csv", content)) {}

  TableRows rows(std::string const& argument = "depth", std::string const& value = "vp",
                 std::string const& argument_unit = "", std::string const& value_unit = "") const
  {
    return TableFile(name_, "f / File Name")
      .rows({argument, "f / Argument Column", argument_unit, "f / Argument Unit"},
            {value, "f / Value Column", value_unit, "f / Value Unit"});
  }

  TableFunction function() const { return TableFunction(rows(), {}, "f"); }

  std::uint64_t checksum() const { return checksumOfFile(name_, "f"); }

private:
  TemporaryDirectory directory_;
  std::string name_;
};

TEST(TableFile, ReadsColumnsByNameInSiUnits)
{
  const CrustFile file(
    "\xef\xbb\xbf# a crust\r\n\r\n"
    "layer, vp [km/s], depth [km], density [g/cm^3], count, vp_vs [-]\r\n"
    "soil, 1.5, 0, 1.9, +3, 2\r\n# the basement\r\nrock, 5.8, 2.5, 2.67, 4e0, 1.7");
  const auto vp = file.rows();
  EXPECT_EQ(vp.arguments, (std::vector<double>{0, 2500}));
  EXPECT_EQ(vp.values, (std::vector<double>{1500, 5800}));
  EXPECT_EQ(vp.place(1).substr(0, 8), "line 6 o");
  EXPECT_EQ(file.rows("depth", "density").values, (std::vector<double>{1900, 2670}));
  EXPECT_EQ(file.rows("count", "vp_vs").arguments, (std::vector<double>{3, 4}));
  EXPECT_EQ(file.rows("count", "vp", "h").arguments, (std::vector<double>{10800, 14400}));
  EXPECT_EQ(file.rows("depth", "vp", "km", "km/s").arguments, vp.arguments);
}

TEST(TableFile, RefusesDamagedFilesByName)
{
  const std::string head = "depth [km], vp [km/s]\n";
  const auto refused = [](std::string const& content) {
    return refusal([&] { CrustFile(content).function(); });
  };
  EXPECT_EQ(CrustFile(head + "0, 5\n10, 6\n").function()(5e3), 5500);
  expectParts(refused(""), {"f / File Name = '", "crust.csv' is empty"});
  expectParts(refused("\n# nothing\n"), {"crust.csv' is empty"});
  expectParts(refused(head), {"f: a table needs two rows", "has 0."});
  expectParts(refused(head + "0, 5\n"), {"f: a table needs two rows", "has 1."});
  expectParts(refused(head + "0, 5\n10\n"),
              {"f / File Name = '", "line 3: '10' has 1 entries", "2 columns"});
  expectParts(refused(head + "0, 5\n10, \n"), {"line 3", "column 'vp': '' is no finite number"});
  expectParts(refused(head + "0, 5\n10, nan\n"), {"line 3", "column 'vp': 'nan' is no finite"});
  expectParts(refused(head + "0, 5\ninf, 5\n"), {"line 3", "column 'depth': 'inf' is no finite"});
  expectParts(refused(head + "0, 5\n10, 6 km\n"), {"line 3", "'6 km'"});
  expectParts(refused(head + "0, 5\n1,5, 6\n"), {"line 3", "has 3 entries"});
  expectParts(refused(head + "0, 5\n10, 6\n5, 7\n"),
              {"f, line 4 of '", "crust.csv'", "5000 is less than 10000"});
  expectParts(refused("depth [km], vp [km/s]\n6, 0\n5.8, 1\n"), {"line 3", "5800 is less than"});
  expectParts(refused("0, 5\n10, 6\n"),
              {"f / Argument Column = 'depth'", "no such column", "first line has to name"});
  expectParts(refused("dept [km], vp [km/s]\n0, 5\n"), {"Did you mean 'dept'?"});
  expectParts(refused("depth [km]; vp [km/s]\n0; 5\n"), {"'vp'", "no such column", "commas"});
  expectParts(refused("depth [km], depth [m], vp\n0, 0, 5\n"), {"2 columns of this name"});
  expectParts(refused("depth [miles], vp\n0, 5\n10, 6\n"),
              {"column 'depth'", "the unit 'miles' is unknown"});
  expectRefusal([&] { CrustFile(head + "0, 5\n10, 6\n").rows("depth", "vp", "m"); },
                {"f / Argument Unit = 'm', but '", "the column 'depth' in [km]"});
  expectRefusal([&] { CrustFile(head + "0, 5\n10, 6\n").rows("vp", "depth", "", "km/s"); },
                {"f / Value Unit = 'km/s', but '", "the column 'depth' in [km]"});
}

TEST(TableFile, RefusesAFileThatIsNotThere)
{
  const TemporaryDirectory directory;
  directory.write("crust.csv", "");
  expectRefusal([&] { TableFile(directory.file("crsut.csv"), "f / File Name"); },
                {"f / File Name = '", "there is no such file", "Did you mean 'crust.csv'?"});
  expectRefusal([&] { TableFile(directory.file(""), "f / File Name"); }, {"cannot be read"});
}

TEST(TableFile, ChecksumIsThatOfTheContent)
{
  const CrustFile one("depth, vp\n0, 1\n"), other("depth, vp\n0, 2\n"), twin("depth, vp\n0, 1\n");
  EXPECT_EQ(one.checksum(), twin.checksum());
  EXPECT_NE(one.checksum(), other.checksum());
}

Expression::Tables tables()
{
  auto result = std::make_shared<TableFunctions>();
  result->of_name.emplace("vp", TableFunction({{0, 1, 2}, {10, 20, 40}}, {}, "Tables / vp"));
  result->of_name.emplace(
    "layer", TableFunction({{0, 1, 2}, {1, 2, 3}}, {Interpolation::step}, "Tables / layer"));
  return result;
}

double valueOf(std::string const& text, std::array<double, 3> const& x, double t = 0)
{
  return Expression(text, "Bulk / Density", tables())(x, t);
}

TEST(TablesInExpressions, AreFunctionsOfOneVariable)
{
  EXPECT_EQ(valueOf("vp(-z)", {0, 0, -1.5}), 30);
  EXPECT_EQ(valueOf("2 * vp( abs(x) + y ) - layer(t)", {-0.5, 0.5, 0}, 1), 38);
  EXPECT_EQ(valueOf("vp(layer(0))", {}), 20);
  EXPECT_EQ(valueOf("vp(0.5)", {}), 15);
  const Expression of_place("vp(-z)", "a", tables()), of_time("vp(t)", "a", tables()),
    constant("vp(1)", "a", tables());
  EXPECT_TRUE(of_place.dependsOnSpace() && !of_place.dependsOnTime());
  EXPECT_TRUE(of_time.dependsOnTime() && !of_time.dependsOnSpace());
  EXPECT_FALSE(constant.dependsOnSpace() || constant.dependsOnTime());
  EXPECT_EQ(*Expression::constants("vp(1), 2 * layer(2)", "a", tables()),
            (std::vector<double>{20, 6}));
}

TEST(TablesInExpressions, AreCalledWhereTheyCountAlone)
{
  EXPECT_EQ(valueOf("z > -1 ? 7 : vp(-z)", {0, 0, 5}), 7);
  EXPECT_EQ(valueOf("z > -1 ? 7 : vp(-z)", {0, 0, -2}), 40);
  EXPECT_EQ(valueOf("vp(1 + x)", {1, 0, 0}), 40); // at the origin, too
  EXPECT_EQ(valueOf("vp(x - 5)", {5, 0, 0}), 10); // but there it has no value at the origin
}

TEST(TablesInExpressions, NameThePlaceWhereTheyHaveNoValue)
{
  expectRefusal(
    [] {
      valueOf("1 + vp(-z)", {1, 2, -3}, 4);
    },
    {"Bulk / Density = '1 + vp(-z)' has no value at (x, y, z) = (1, 2, -3) m, t = 4 s",
     "Tables / vp has arguments from 0 to 2, but 3 is wanted"});
  expectRefusal([] { valueOf("vp(7)", {}); },
                {"Bulk / Density = 'vp(7)' has no value", "but 7 is wanted"});
  expectRefusal([] { Expression::constants("vp(7)", "a", tables()); }, {"a = 'vp(7)'", "7"});
}

TEST(TablesInExpressions, AreRefusedLikeOtherFunctions)
{
  expectRefusal([] { valueOf("vp", {}); }, {"Bulk / Density = 'vp' is no valid expression"});
  expectRefusal([] { valueOf("vp(x, y)", {}); }, {"no valid expression"});
  expectRefusal([] { valueOf("vs(x)", {}); }, {"vs", "its Tables 'layer', 'vp'"});
  expectRefusal([] { Expression("vp(x)", "a"); }, {"a = 'vp(x)' is no valid expression"});
}

// A mean takes what the table has on both sides of its jump; the value itself is one of the two.
TEST(TablesInExpressions, AreSampledByMeans)
{
  const std::array<std::array<double, 3>, 2> places = {{{0, 0, -0.9}, {0, 0, -1.1}}};
  const std::array<double, 2> weights = {0.25, 0.75};
  const Expression::Patch patch = {places.data(), weights.data(), 2};
  const Expression mean("mean(layer(-z))", "a", tables()), value("layer(-z)", "a", tables());
  EXPECT_TRUE(mean.takesMeans());
  EXPECT_EQ(mean({0, 0, -1}, 0, patch), 1.75);
  EXPECT_EQ(mean({0, 0, -1}, 0), 2);
  EXPECT_EQ(value({0, 0, -1}, 0, patch), 2);
}

TEST(TablesInExpressions, HaveNamesThatFormulasDoNotUse)
{
  Expression::requireFreeName("vp_2", "Tables / vp_2");
  for (std::string const taken : {"x", "t", "e", "pi", "sin", "mean", "if"}) {
    expectRefusal([&] { Expression::requireFreeName(taken, "Tables / f"); },
                  {"Tables / f: '" + taken + "' has a meaning", "another name"});
  }
  for (std::string const none : {"", "2d", "v p", "v-p", "1e5"}) {
    expectRefusal([&] { Expression::requireFreeName(none, "Tables / f"); },
                  {"cannot be used in an expression"});
  }
}
} // namespace
