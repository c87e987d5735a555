// Warnings about bodies whose size does not fit their waves, steps and friction.
#include "scenario/checks/SizeCheck.hpp"

#include "SampleDeck.hpp"
#include "scenario/report/RunReport.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
using namespace test;

namespace
{
// A fault of 10 km in a body of 40 km, with cells of 100 m: rock with c_s = 3464 m/s, L = 1 cm.
BodySize crust()
{
  BodySize size;
  size.longest_axis = 40e3;
  size.extent = 57e3;
  size.crossing_time = 57e3 / 3464;
  size.cell_time = 100. / 3464;
  size.has_waves = true;
  size.final_time = 3e9;
  return size;
}

dynamics::FaultResolution resolved()
{
  const double modulus = 40e9, a = 0.010, b = 0.015, L = 0.01, stress = 50e6;
  const double zone = dynamics::cohesiveZone(modulus, b, L, stress);
  dynamics::FaultResolution resolution{100,
                                       100,
                                       zone,
                                       dynamics::nucleationLength(modulus, a, b, L, stress),
                                       dynamics::unstableWavelength(modulus, a, b, L, stress),
                                       zone / 100,
                                       1};
  resolution.slip_distance = L;
  return resolution;
}

// The same numbers, read in another unit.
void multiply(double factor, BodySize& size, dynamics::FaultResolution& resolution)
{
  for (double* length : {&size.longest_axis, &size.extent, &size.crossing_time, &size.cell_time,
                         &resolution.smallest_cell, &resolution.largest_cell}) {
    *length *= factor;
  }
}

std::vector<std::string> texts(BodySize const& size,
                               std::optional<dynamics::FaultResolution> const& resolution)
{
  std::vector<std::string> found;
  for (auto const& warning : warnOfSize(size, resolution)) {
    found.push_back(warning.topic + ": " + warning.text);
  }
  return found;
}

bool warns(ParameterList const& deck, std::string const& topic)
{
  const auto warnings = describe(makeProblem<2>(deck, world())).warnings;
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](Warning const& warning) { return warning.topic == topic; });
}
} // namespace

TEST(SizeCheck, IsSilentForRockInMetres)
{
  EXPECT_EQ(texts(crust(), resolved()), std::vector<std::string>());
  EXPECT_EQ(texts(crust(), std::nullopt), std::vector<std::string>());
}

TEST(SizeCheck, KilometresReadAsMetres)
{
  auto size = crust();
  auto resolution = resolved();
  multiply(1e-3, size, resolution);
  auto found = texts(size, resolution);
  ASSERT_EQ(found.size(), 1u);
  expectParts(found[0], {"size of the body: The body is 57 m large", "lengths of 5026.55 m",
                         "it creeps", "--scale 1000"});
  // Without friction that weakens only waves and steps are known.
  EXPECT_TRUE(texts(size, std::nullopt).empty());
  size.smallest_step = 0.1;
  found = texts(size, std::nullopt);
  ASSERT_EQ(found.size(), 1u);
  expectParts(found[0], {"0.016455", "through the whole body", "0.1 s", "--scale 1000"});
  size.smallest_step = 0.01;
  EXPECT_TRUE(texts(size, std::nullopt).empty());
}

TEST(SizeCheck, MetresReadAsKilometres)
{
  auto size = crust();
  auto resolution = resolved();
  multiply(1e3, size, resolution);
  auto found = texts(size, resolution);
  ASSERT_EQ(found.size(), 1u);
  expectParts(found[0], {"The body is 40000 km long, more than the earth"});
  // A smaller body, in which a rupture of ten seconds does not leave a cell.
  size.longest_axis = 10e6;
  EXPECT_TRUE(texts(size, resolution).empty());
  size.final_time = 10;
  found = texts(size, resolution);
  ASSERT_EQ(found.size(), 1u);
  expectParts(found[0], {"28.8684 s through the smallest cell", "ends after 10 s"});
  size.has_waves = false;
  EXPECT_TRUE(texts(size, resolution).empty());
}

TEST(SizeCheck, CellsShorterThanTheSlipDistance)
{
  auto resolution = resolved();
  resolution.smallest_cell = 0.009;
  const auto found = texts(crust(), resolution);
  ASSERT_EQ(found.size(), 1u);
  expectParts(found[0], {"size of cells: ", "0.009 m long", "0.01 m"});
}

TEST(SizeCheck, KnowsTheBodyOfADeck)
{
  const auto deck = strip();
  const auto problem = makeProblem<2>(deck, world());
  const auto size = bodySize(problem);
  const double speed = std::sqrt(1e6 / 1000);
  EXPECT_DOUBLE_EQ(size.longest_axis, 2);
  EXPECT_DOUBLE_EQ(size.extent, std::sqrt(8));
  EXPECT_DOUBLE_EQ(size.crossing_time, std::sqrt(8) / speed);
  EXPECT_DOUBLE_EQ(size.cell_time, std::sqrt(2) / speed);
  EXPECT_EQ(size.smallest_step, 1e-3);
  EXPECT_EQ(size.final_time, 10);
  EXPECT_FALSE(warns(deck, "size of the body"));
  EXPECT_TRUE(warns(strip([](ParameterList& given) {
                      auto& rectangle = given.sublist("Mesh").sublist("Rectangle");
                      rectangle.set("Width", 2e-3).set("Height", 2e-3);
                    }),
                    "size of the body"));
}

TEST(SizeCheck, DoesNotBlameTheMeshForANormalStressInAnotherUnit)
{
  const auto deck =
    strip([](ParameterList& given) { given.sublist("Friction").set("Normal Stress", 1e-2); });
  EXPECT_TRUE(warns(deck, "normal stress"));
  EXPECT_FALSE(warns(deck, "size of the body"));
}

// A fault of 2 m along which slip is prescribed for 10 s.
TEST(SizeCheck, PrescribedSlipOfMoreThanAFewPercent)
{
  const auto slips = [](std::string const& rate) {
    return warns(strip([&](ParameterList& given) {
                   given.sublist("Mesh").sublist("Faults").set("main", "abs(y - 1) < 1e-6");
                   auto& fault = given.sublist("Boundary Conditions").sublist("Fault");
                   fault.set("Boundary", "main").set("Type", "Prescribed Slip Rate");
                   fault.set("Slip Rate", rate);
                 }),
                 "prescribed slip");
  };
  EXPECT_TRUE(slips("0.0101"));
  EXPECT_FALSE(slips("0.0099"));
  EXPECT_TRUE(slips("-0.03 * (1 - x / 2) * (t < 5)")) << "0.15 m at x = 0";
  EXPECT_FALSE(slips("t == 10 * 63.5 / 128 ? 100 : 0")) << "a pulse in one of the times";
}
} // namespace asperity::scenario
