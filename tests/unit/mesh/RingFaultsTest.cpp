// Faults that close: plus is the outside.
#include "FaultSamples.hpp"

#include <cmath>

namespace asperity::mesh
{
namespace
{
// The square of half a side of 1 around (2, 0), and the cube around (2, 0, 2).
double awayFrom(Point<2> const& x) { return std::max(std::abs(x[0] - 2), std::abs(x[1])); }
double awayFrom(Point<3> const& x)
{
  return std::max({std::abs(x[0] - 2), std::abs(x[1]), std::abs(x[2] - 2)});
}

template <int Dim>
bool isOnRing(Point<Dim> const& x)
{
  return std::abs(awayFrom(x) - 1) < 1e-9;
}

// From (2, 0) or (2, 0, 2) or, if `axis` is not negative, from the line along this axis.
template <int Dim>
void expectPlusOutside(GlobalMesh<Dim> const& mesh, std::string const& fault, int axis = -1)
{
  for (auto const& facet : mesh.boundaries.at(fault)) {
    const auto points = corners(mesh, facet);
    auto outwards = centroid(points);
    outwards[0] -= 2;
    if (Dim == 3) {
      outwards[Dim - 1] -= 2;
    }
    if (axis >= 0) {
      outwards[axis] = 0;
    }
    EXPECT_LT(dot<Dim>(facetNormal(points), outwards), 0) << fault << " at " << outwards[1];
  }
}
} // namespace

TEST(RingFaults, OfOneName)
{
  const auto before = faultedRectangle({{"ring", isOnRing<2>}}, 2);
  const auto mesh = split(before);
  expectPlusOutside(mesh, "ring");
  expectCutAlongFaultsOnly(before, mesh);
  EXPECT_EQ(numTipsAndOthers(mesh), std::make_pair(0, 16));
}

TEST(RingFaults, OfTwoOpenHalves)
{
  for (const char* upper : {"a", "z"}) { // the first and the last name
    const auto before = faultedRectangle(
      {{"m", isOnRing<2>},
       {upper, [](Point<2> const& x) { return isOnRing<2>(x) && x[1] > 0.1 - 1e-9; }}},
      2);
    const auto mesh = split(before);
    expectPlusOutside(mesh, "m");
    expectPlusOutside(mesh, upper);
    expectCutAlongFaultsOnly(before, mesh);
    EXPECT_EQ(numTipsAndOthers(mesh).first, 0);
  }
}

TEST(RingFaults, WithAGap)
{
  const auto with_gap = [](double gap) {
    return [gap](Point<2> const& x) {
      return isOnRing<2>(x) && !(x[1] < -0.9 && std::abs(x[0] - 2) < gap);
    };
  };
  // 31 of 32 edges: nearly closed. 24 of 32: open, and plus is the upper side everywhere.
  const auto nearly = split(faultedRectangle({{"ring", with_gap(0.13)}}, 4));
  EXPECT_EQ(nearly.boundaries.at("ring").size(), 30u);
  const auto up = upOf(nearly, "ring");
  EXPECT_NEAR(up[1], 0.5, 1e-9); // what is missing below
  const auto open = split(faultedRectangle({{"ring", with_gap(0.99)}}, 4));
  EXPECT_NEAR(upOf(open, "ring")[1], 2, 1e-9);
}

TEST(RingFaults, InSpace)
{
  const auto before = faultedBox({{"ball", isOnRing<3>}});
  const auto mesh = split(before);
  expectPlusOutside(mesh, "ball");
  expectCutAlongFaultsOnly(before, mesh);
  EXPECT_EQ(numTipsAndOthers(mesh), std::make_pair(0, 26));
}

TEST(RingFaults, ACylinderThatReachesTheSurface)
{
  const auto is_on_cylinder = [](Point<3> const& x) {
    return std::abs(std::max(std::abs(x[0] - 2), std::abs(x[2] - 2)) - 1) < 1e-9;
  };
  const auto mesh =
    split(faultedBox({{"west", is_on_cylinder}, {"east", [&](Point<3> const& x) {
                                                   return is_on_cylinder(x) && x[0] > 2 - 1e-9;
                                                 }}}));
  expectPlusOutside(mesh, "west", 1);
  expectPlusOutside(mesh, "east", 1);
}

TEST(RingFaults, ThreeNamesThatMeet)
{
  const auto mesh = faultedRectangle(
    {{"west", [](Point<2> const& x) { return std::abs(x[1]) < 1e-9 && x[0] < 2 + 1e-9; }},
     {"east",
      [](Point<2> const& x) { return std::abs(x[1] - x[0] + 2) < 1e-9 && x[0] > 2 - 1e-9; }},
     {"south", [](Point<2> const& x) { return std::abs(x[0] - 2) < 1e-9 && x[1] < 1e-9; }}},
    2);
  test::expectRefusal([&] { split(mesh); },
                      {"faults 'east', 'south' and 'west' meet at (2, 0)", "the same name"});
  // The remedy: two of them as one.
  auto joined = mesh;
  auto& main = joined.boundaries["main"];
  for (char const* name : {"west", "east"}) {
    main.insert(main.end(), joined.boundaries[name].begin(), joined.boundaries[name].end());
    joined.boundaries.erase(name);
  }
  const auto pairs = pairsAt(split(joined), {2., 0.});
  ASSERT_EQ(pairs.size(), 1u + 1u);
  EXPECT_NE(pairs[0].is_tip, pairs[1].is_tip) << "the cut, and the tip of the branch";
}
} // namespace asperity::mesh
