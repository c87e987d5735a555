#include "scenario/report/FaultSense.hpp"

#include "SampleDeck.hpp"

#include <cmath>

namespace asperity::scenario
{
using namespace test;

namespace
{
std::string inPlane(double x, double y, int components = 2, double slip = 1)
{
  return senseInWords({{x, y, 0}, 2, components}, slip);
}
} // namespace

// The hanging wall is above the fault; a thrust moves it up dip. In a map who looks across a right
// lateral fault sees the other side move to the right.
TEST(FaultSense, InAPlane)
{
  EXPECT_EQ(inPlane(0, 1), "right lateral in a map") << "the upper side along +x";
  EXPECT_EQ(inPlane(0, -1), "left lateral in a map");
  // Dips to the right at 37 degrees; the tangent is (0.8, -0.6), down dip.
  EXPECT_EQ(inPlane(0.6, 0.8), "a normal fault in a section, right lateral in a map");
  EXPECT_EQ(inPlane(0.6, 0.8, 2, -1e-9), "a thrust in a section, left lateral in a map");
  EXPECT_EQ(inPlane(-0.6, -0.8), "a thrust in a section, left lateral in a map")
    << "the plus side is the footwall, and goes down";
  EXPECT_EQ(inPlane(-0.6, 0.8), "a thrust in a section, right lateral in a map");
  // Steep, dips to the right; the tangent is (-0.28, 0.96), up dip.
  EXPECT_EQ(inPlane(0.96, 0.28), "a thrust in a section, left lateral in a map");
  EXPECT_EQ(inPlane(1, 0), "the plus side up in a section, left lateral in a map");
}

// Under gravity the plane is upright: nothing in it is lateral, and gravity says where up is.
TEST(FaultSense, InASection)
{
  const auto sense = [](std::array<double, 3> const& up, std::array<double, 3> const& plus,
                        double slip) {
    return senseInWords({plus, 2, 2, up, true}, slip);
  };
  EXPECT_EQ(sense({0, 1, 0}, {0.6, 0.8, 0}, 1), "a normal fault");
  EXPECT_EQ(sense({0, 1, 0}, {1, 0, 0}, 1), "the plus side up");
  EXPECT_EQ(sense({0, 1, 0}, {0, 1, 0}, 1), "neither up nor down");
  // The base of a wedge, whose gravity is inclined: to the right the base is deeper.
  EXPECT_EQ(sense({-0.28, 0.96, 0}, {0, 1, 0}, 1), "a normal fault");
  EXPECT_EQ(sense({-0.28, 0.96, 0}, {0, 1, 0}, -1), "a thrust");
}

TEST(FaultSense, AcrossAPlane)
{
  EXPECT_EQ(inPlane(1, 0, 1), "right lateral seen from above");
  EXPECT_EQ(inPlane(-1, 0, 1), "left lateral seen from above");
  EXPECT_EQ(inPlane(1, 0, 1, -1), "left lateral seen from above");
  EXPECT_EQ(senseOfSlip({{1, 0, 0}, 2, 1}),
            "positive slip moves it along +z, out of the plane: right lateral seen from above");
}

TEST(FaultSense, InSpace)
{
  EXPECT_EQ(
    senseOfSlip({{0, 0, 1}, 3, 3}),
    "slip has parts along the axes; strike 90, dip 90; along (-1, 0, 0) it is right lateral");
  EXPECT_EQ(
    senseOfSlip({{0.6, 0.8, 0}, 3, 3}),
    "slip has parts along the axes; strike 0, dip 36.9; along (0, 0, 1) it is right lateral, "
    "upwards a thrust");
  EXPECT_EQ(senseOfSlip({{0, -1, 0}, 3, 3}), "slip has parts along the axes; the fault is level");
}

// Aki and Richards: with z up, x east and y north a plane of this strike and dip has a hanging wall
// towards (sin dip cos strike, -sin dip sin strike, cos dip), and slips along the rake by
// (cos rake) s + (sin rake) u, where s is along strike and u up dip.
TEST(FaultSense, StrikeDipAndRakeAreThoseOfAkiAndRichards)
{
  constexpr double degree = M_PI / 180;
  for (const double strike : {0., 30., 90., 200., 315.}) {
    for (const double dip : {10., 45., 80.}) {
      const double s = strike * degree, d = dip * degree;
      const std::array<double, 3> hanging = {std::sin(d) * std::cos(s), -std::sin(d) * std::sin(s),
                                             std::cos(d)};
      const std::array<double, 3> along = {std::sin(s), std::cos(s), 0};
      const std::array<double, 3> up_dip = {-std::cos(d) * std::cos(s), std::cos(d) * std::sin(s),
                                            std::sin(d)};
      for (const double plus : {1., -1.}) { // the hanging wall, the foot wall
        FaultSides sides{{}, 3, 3, {0, 0, 1}};
        for (int c = 0; c < 3; ++c) {
          sides.plus[c] = plus * hanging[c];
        }
        auto const found = strikeAndDip(sides);
        EXPECT_NEAR(found.strike, strike, 1e-9);
        EXPECT_NEAR(found.dip, dip, 1e-9);
        for (const double rake : {-135., -90., 0., 60., 180.}) {
          std::array<double, 3> slip{}; // of the plus side
          for (int c = 0; c < 3; ++c) {
            slip[c] =
              plus * (std::cos(rake * degree) * along[c] + std::sin(rake * degree) * up_dip[c]);
          }
          EXPECT_NEAR(std::abs(rakeOf(sides, slip)), std::abs(rake), 1e-9);
          EXPECT_GE(rakeOf(sides, slip) * rake, 0);
        }
      }
    }
  }
}

TEST(FaultSense, RakeInWords)
{
  const FaultSides thrust{{0, -0.6, 0.8}, 3, 3, {0, 0, 1}}; // dips to the south
  EXPECT_EQ(rakeInWords(thrust, {0, 0.8, 0.6}), "rake 90, a thrust");
  EXPECT_EQ(rakeInWords(thrust, {0, -2, 0}), "rake -90, a normal fault") << "its part along it";
  EXPECT_EQ(rakeInWords(thrust, {1, 0, 0}), "rake 0, left lateral");
  EXPECT_EQ(rakeInWords(thrust, {-1, 0.8, 0.6}), "rake 135, right lateral and a thrust");
  EXPECT_EQ(rakeInWords(thrust, {0, -0.6, 0.8}), "") << "across the fault";
  EXPECT_EQ(rakeInWords({{0, 0, 1}, 3, 3, {0, 0, 1}}, {1, 0, 0}), "") << "level";
  EXPECT_EQ(rakeInWords({{1, 0, 0}, 3, 3, {0, 0, 1}}, {0, 0, -1}), "rake -90, the plus side down");
}
} // namespace asperity::scenario
