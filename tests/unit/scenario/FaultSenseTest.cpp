#include "scenario/FaultSense.hpp"

#include "SampleDeck.hpp"

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
  EXPECT_EQ(senseOfSlip({{0, 0, 1}, 3, 3}),
            "slip has parts along the axes; along (-1, 0, 0) it is right lateral");
  EXPECT_EQ(senseOfSlip({{0.6, 0.8, 0}, 3, 3}),
            "slip has parts along the axes; along (0, 0, 1) it is right lateral, upwards a thrust");
  EXPECT_EQ(senseOfSlip({{0, -1, 0}, 3, 3}), "slip has parts along the axes; the fault is level");
}
} // namespace asperity::scenario
